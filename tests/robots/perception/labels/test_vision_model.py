"""A model behind an address is asked once for each thing, and what it answers is not trusted."""

import json
import threading
from http.server import BaseHTTPRequestHandler, HTTPServer

import pytest

from robots.perception.labels.model_address import VisionModel
from robots.perception.labels.vision_model import VisionLabeller
from tests.robots.perception.labels.conftest import package, table


def said(*answers):
    content = json.dumps({"answers": list(answers)})
    return json.dumps({"choices": [{"message": {"content": f"Sure: {content}"}}]}).encode()


@pytest.fixture
def server():
    class Handler(BaseHTTPRequestHandler):
        answer, asked = b"", []

        def do_POST(self):
            body = self.rfile.read(int(self.headers["Content-Length"]))
            Handler.asked.append((self.path, self.headers.get("Authorization"), json.loads(body)))
            self.send_response(200)
            self.end_headers()
            self.wfile.write(Handler.answer)

        def log_message(self, *args):
            pass

    Handler.asked = []
    served = HTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=served.serve_forever, daemon=True)
    thread.start()
    yield Handler, VisionModel(f"http://127.0.0.1:{served.server_port}/v1", "eyes", "secret", 5.0)
    served.shutdown()
    thread.join()
    served.server_close()


def test_what_a_model_answers_becomes_scores(server):
    handler, model = server
    handler.answer = said(
        {"picture": 1, "label": "soup", "score": 0.9}, {"picture": 2, "label": "none", "score": 1.0}
    )
    image, boxes = table(package(1), package(2))

    assert VisionLabeller(model).scores(image, boxes, ("soup", "tea")).tolist() == [[0.9, 0.0], [0.0, 0.0]]
    path, key, body = handler.asked[0]
    assert (path, key, body["model"]) == ("/v1/chat/completions", "Bearer secret", "eyes")
    assert sum(part["type"] == "image_url" for part in body["messages"][0]["content"]) == 2


def test_what_stays_in_place_is_not_asked_again(server):
    handler, model = server
    handler.answer = said({"picture": 1, "label": "soup", "score": 0.9})
    image, boxes = table(package(1))
    labeller = VisionLabeller(model)

    first, second = (labeller.scores(image, boxes, ("soup",)) for _ in range(2))

    assert len(handler.asked) == 1
    assert first.tolist() == second.tolist() == [[0.9]]


@pytest.mark.parametrize(
    "answer",
    [
        b"no JSON",
        b'{"choices": []}',
        said({"picture": 1}),
        said({"picture": "x", "label": "soup", "score": 1}),
        b"x" * 70_000,
        b'{"choices": [{"message": {"content": null}}]}',
    ],
    ids=["no JSON", "nothing", "no label", "no number", "too long", "null"],
)
def test_an_answer_of_another_form_tells_nothing(server, answer):
    handler, model = server
    handler.answer = answer
    image, boxes = table(package(1))
    labeller = VisionLabeller(model)

    assert not labeller.scores(image, boxes, ("soup",)).any()
    assert labeller.trouble


def test_a_score_or_a_picture_that_cannot_be_does_not_count(server):
    handler, model = server
    handler.answer = said(
        {"picture": 5, "label": "soup", "score": 0.9}, {"picture": 1, "label": "soup", "score": 7}
    )
    image, boxes = table(package(1))

    assert not VisionLabeller(model).scores(image, boxes, ("soup",)).any()


def test_a_server_that_is_not_there_tells_nothing():
    image, boxes = table(package(1))
    labeller = VisionLabeller(VisionModel("http://127.0.0.1:9/v1", "eyes", timeout_s=1.0))

    assert not labeller.scores(image, boxes, ("soup",)).any()
    assert "127.0.0.1:9" in labeller.trouble
