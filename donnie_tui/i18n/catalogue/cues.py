"""The cues by name: what each says without a word."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    "cue-step-forward": Sentence("A step forward.", "Um passo para frente.", "Un paso adelante."),
    "cue-step-back": Sentence("A step back.", "Um passo para trás.", "Un paso atrás."),
    "cue-turn-right": Sentence("10 degrees to the right.", "10 graus à direita.", "10 grados a la derecha."),
    "cue-turn-left": Sentence("10 degrees to the left.", "10 graus à esquerda.", "10 grados a la izquierda."),
    "cue-obstacle": Sentence("An obstacle is near.", "Um obstáculo está perto.", "Hay un obstáculo cerca."),
    "cue-bump": Sentence("A collision.", "Uma colisão.", "Un choque."),
    "cue-scan": Sentence("Looking around.", "Olhando em volta.", "Mirando alrededor."),
    "cue-found": Sentence("A thing was found.", "Um objeto foi achado.", "Se halló una cosa."),
    "cue-belt": Sentence("The belt vibrates.", "O cinto vibra.", "El cinturón vibra."),
    "cue-done": Sentence("The program is done.", "O programa terminou.", "El programa terminó."),
    "cue-error": Sentence("An error.", "Um erro.", "Un error."),
    "cue-waiting": Sentence("Waiting.", "Esperando.", "Esperando."),
    "cue-block-opened": Sentence("A block begins.", "Um bloco começa.", "Un bloque empieza."),
    "cue-block-closed": Sentence("A block ends.", "Um bloco termina.", "Un bloque termina."),
    "cues-silent": Sentence(
        "Sounds are off here. Start donnie with --sound on.",
        "Os sons estão desligados aqui. Inicie o donnie com --sound on.",
        "Los sonidos están apagados aquí. Inicia donnie con --sound on.",
        brief=(
            "Sounds are off. Start with --sound on.",
            "Sem sons. Inicie com --sound on.",
            "Sin sonidos. Inicia con --sound on.",
        ),
    ),
    "cues-switched-off": Sentence(
        "Sounds are off. SOUND ON turns them on.",
        "Os sons estão desligados. SOM LIGADO liga.",
        "Los sonidos están apagados. SONIDO ENCENDIDO los enciende.",
        brief=(
            "Sounds are off. SOUND ON helps.",
            "Sem sons. SOM LIGADO liga.",
            "Sin sonidos. Usa SONIDO ENCENDIDO.",
        ),
    ),
    "cues-no-device": Sentence(
        "No sounds: there is no sound device. The command donnie doctor says what to do.",
        "Sem sons: não há dispositivo de som. O comando donnie doctor diz o que fazer.",
        "Sin sonidos: no hay dispositivo de sonido. El comando donnie doctor dice qué hacer.",
        brief=(
            "No sound device. See donnie doctor.",
            "Sem dispositivo. Veja donnie doctor.",
            "Sin dispositivo. Ve donnie doctor.",
        ),
    ),
}
