"""One request to an OpenAI-compatible server: what it answers is read to a bound, and every ending is typed.

The only module that speaks to such a server. It follows no redirection, heeds no proxy of the environment,
tries nothing a second time, and tells the server nothing of this machine.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import httpx2
import openai

from executive.front.model_settings import ModelSettings
from executive.front.proposal import ModelFailure, ModelFailureKind
from executive.understanding.strict_output import NAME, strict_output_schema
from executive.understanding.untrusted_json import UntrustedJsonError, read_json
from robots.clock import WallClock

MOST_BYTES = 65_536
"""Of an answer: some hundred times what a few steps take."""
MOST_TOKENS = 1_000

_OF_THIS_MACHINE = ("Lang", "Package-Version", "OS", "Arch", "Runtime", "Runtime-Version", "Async")
_NO_KEY = "none"


class ModelClient:
    """A client of one model's server.

    Args:
        settings: Where it is, and what the model is called there.
        key: The key; empty where the server wants none.
    """

    def __init__(self, settings: ModelSettings, key: str) -> None:
        self._settings, self._wall = settings, WallClock()
        self._headers = _headers(bool(key))
        self._client = openai.OpenAI(
            base_url=settings.url,
            api_key=key or _NO_KEY,
            organization="",
            project="",
            max_retries=0,
            timeout=settings.timeout_s,
            http_client=openai.DefaultHttpxClient(follow_redirects=False, trust_env=False),
        )

    def close(self) -> None:
        """Close its connections."""
        self._client.close()

    def ask(self, messages: Sequence[Mapping[str, str]]) -> str | ModelFailure:
        """The text of the model's answer, of the form of strict output, or why there is none.

        Args:
            messages: Role and content of each.
        """
        form = {"name": NAME, "strict": True, "schema": strict_output_schema()}
        return self._typed(messages, {"type": "json_schema", "json_schema": form})

    def ask_about(self, content: Sequence[Mapping[str, Any]]) -> str | ModelFailure:
        """The text of the model's answer, of any form, or why there is none.

        Args:
            content: Parts of one message: texts and pictures.
        """
        return self._typed([{"role": "user", "content": [dict(part) for part in content]}], openai.omit)

    def _typed(self, messages: Sequence[Mapping[str, Any]], form: Any) -> str | ModelFailure:
        try:
            return self._asked(messages, form)
        except openai.APITimeoutError:
            return self._too_slow()
        except openai.APIConnectionError as wrong:
            why = wrong.__cause__ or wrong
            return ModelFailure.of(ModelFailureKind.UNREACHABLE, f"{self._settings.url}: {why}")
        except httpx2.TimeoutException:
            return self._too_slow()
        except httpx2.HTTPError as broken:
            return ModelFailure.of(ModelFailureKind.UNREACHABLE, f"{self._settings.url}: {broken}")
        except openai.RateLimitError:
            return ModelFailure.of(ModelFailureKind.RATE_LIMITED)
        except (openai.AuthenticationError, openai.PermissionDeniedError) as wrong:
            told = f"{wrong.status_code}; is the key in {self._variable()}?"
            return ModelFailure.of(ModelFailureKind.DENIED, told)
        except openai.APIStatusError as wrong:
            return ModelFailure.of(ModelFailureKind.SERVER_ERROR, f"status {wrong.status_code}")
        except openai.OpenAIError as wrong:
            return ModelFailure.of(ModelFailureKind.SERVER_ERROR, type(wrong).__name__)

    def _asked(self, messages: Sequence[Mapping[str, Any]], form: Any) -> str | ModelFailure:
        until_s = self._wall.now_s() + self._settings.timeout_s
        sent: Any = [dict(message) for message in messages]
        with self._client.chat.completions.with_streaming_response.create(
            model=self._settings.model,
            messages=sent,
            response_format=form,
            temperature=0.0,
            max_tokens=MOST_TOKENS,
            extra_headers=self._headers,
        ) as response:
            body = bytearray()
            for part in response.http_response.iter_raw(8_192):  # packed ones are not unpacked
                body += part
                if self._wall.now_s() > until_s:
                    return self._too_slow()
                if len(body) > MOST_BYTES:
                    return ModelFailure.of(ModelFailureKind.OVERSIZED, f"more than {MOST_BYTES} bytes")
        return answer_in(bytes(body))

    def _too_slow(self) -> ModelFailure:
        return ModelFailure.of(ModelFailureKind.TIMEOUT, f"{self._settings.timeout_s:g} s were allowed")

    def _variable(self) -> str:
        return self._settings.key_env or "an environment variable that key_env names"


def _headers(has_key: bool) -> Any:
    """Headers of a request: those are left out that tell of this machine, or of a key that there is not."""
    untold = [f"X-Stainless-{name}" for name in _OF_THIS_MACHINE]
    left_out = dict.fromkeys(untold if has_key else [*untold, "Authorization"], openai.omit)
    return {**left_out, "Accept-Encoding": "identity"}


def answer_in(body: bytes) -> str | ModelFailure:
    """The text in a server's answer, or why there is none.

    Args:
        body: What the server sent; untrusted.
    """
    try:
        document = read_json(body.decode("utf-8"))
    except (UnicodeDecodeError, UntrustedJsonError) as wrong:
        return ModelFailure.of(ModelFailureKind.MALFORMED, f"the server's own frame: {wrong}")
    choices = document.get("choices") if isinstance(document, dict) else None
    first = choices[0] if isinstance(choices, list) and choices else None
    message = first.get("message") if isinstance(first, dict) else None
    if not isinstance(first, dict) or not isinstance(message, dict):
        return ModelFailure.of(ModelFailureKind.MALFORMED, "the server sent no message")
    if message.get("refusal"):
        return ModelFailure.of(ModelFailureKind.DECLINED)
    if first.get("finish_reason") == "content_filter":
        return ModelFailure.of(ModelFailureKind.DECLINED, "its filter struck")
    if message.get("tool_calls") or message.get("function_call"):
        return ModelFailure.of(ModelFailureKind.MALFORMED, "it calls a tool, and none was offered")
    if first.get("finish_reason") == "length":
        return ModelFailure.of(ModelFailureKind.OVERSIZED, f"it was cut off after {MOST_TOKENS} tokens")
    content = message.get("content")
    if not isinstance(content, str) or not content.strip():
        return ModelFailure.of(ModelFailureKind.MALFORMED, "it is empty")
    return content
