"""SENSORS: what a robot senses with, and how wide and far it looks."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES = {
    "sensors-title": Sentence("{name} has:", "{name} tem:", "{name} tiene:"),
    "sensors-none": Sentence(
        "{name} has no sensors.", "{name} não tem sensores.", "{name} no tiene sensores."
    ),
    "sensors-board-around": Sentence(
        "Distance sensors all around, range 2 m.",
        "Sensores de distância ao redor, 2 m.",
        "Sensores de distancia alrededor, 2 m.",
    ),
    "sensors-board-head": Sentence(
        "One on its head, which turns for {scan}.",
        "Um na cabeça, que gira para {scan}.",
        "Uno en la cabeza, que gira para {scan}.",
    ),
    "sensors-board-lacks": Sentence(
        "Bumpers. No camera and no gripper.",
        "Sensores de toque. Sem câmera nem garra.",
        "Sensores de choque. Sin cámara ni pinza.",
    ),
    "sensors-several": Sentence("{count} times: {what}", "{count} vezes: {what}", "{count} veces: {what}"),
    "sensors-more": Sentence("And {count} more.", "E mais {count}.", "Y {count} más."),
    "sensors-ranger": Sentence(
        "Distance sensor {where}, {width} degrees wide, range {metres} m.",
        "Sensor de distância {where}, {width} graus de largura, alcance {metres} m.",
        "Sensor de distancia {where}, {width} grados de ancho, alcance {metres} m.",
        brief=(
            "Distance {where}, {width}°, {metres} m.",
            "Distância {where}, {width}°, {metres} m.",
            "Distancia {where}, {width}°, {metres} m.",
        ),
    ),
    "sensors-eyes": Sentence(
        "Color camera {where}, {width} degrees wide, range {metres} m.",
        "Câmera de cores {where}, {width} graus de largura, alcance {metres} m.",
        "Cámara de colores {where}, {width} grados de ancho, alcance {metres} m.",
        brief=(
            "Colors {where}, {width}°, {metres} m.",
            "Cores {where}, {width}°, {metres} m.",
            "Colores {where}, {width}°, {metres} m.",
        ),
    ),
    "sensors-camera": Sentence(
        "Camera {where}, {width} degrees wide, range {metres} m. No picture is made.",
        "Câmera {where}, {width} graus de largura, alcance {metres} m. Não faz imagem.",
        "Cámara {where}, {width} grados de ancho, alcance {metres} m. No hace imagen.",
        brief=(
            "Camera {where}, {width}°, {metres} m.",
            "Câmera {where}, {width}°, {metres} m.",
            "Cámara {where}, {width}°, {metres} m.",
        ),
    ),
    "sensors-bumper": Sentence("Bumper {where}.", "Sensor de toque {where}.", "Sensor de choque {where}."),
    "sensors-gripper": Sentence("Gripper {where}.", "Garra {where}.", "Pinza {where}."),
    "sensors-ahead": Sentence("ahead", "à frente", "al frente"),
    "sensors-behind": Sentence("behind", "atrás", "atrás"),
    "sensors-right": Sentence("{degrees} right", "{degrees} à direita", "{degrees} a la derecha"),
    "sensors-left": Sentence("{degrees} left", "{degrees} à esquerda", "{degrees} a la izquierda"),
}
