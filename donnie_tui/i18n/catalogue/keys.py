"""Keys on the full screen: which there are where the focus is, and changing them; the volume of each sound.

``here-PANE`` is the heading of what can be pressed in a pane, ``here-PANE-N`` are its lines.
"""

from donnie_tui.i18n.sentence import Sentence

_HERE: dict[str, tuple[tuple[str, str, str], ...]] = {
    "program": (
        ("In the program:", "No programa:", "En el programa:"),
        (
            "Letters write, the arrows, Home and End move, Enter begins a line.",
            "As letras escrevem, as setas, Home e End movem, Enter começa uma linha.",
            "Las letras escriben, las flechas, Inicio y Fin mueven, Enter empieza una línea.",
        ),
        (
            "Right arrow at the end of a word: takes the word that is offered.",
            "Seta direita no fim de uma palavra: aceita a palavra oferecida.",
            "Flecha derecha al final de una palabra: acepta la palabra ofrecida.",
        ),
    ),
    "map": (
        ("On the map:", "No mapa:", "En el mapa:"),
        (
            "Arrows: explore it, square by square.",
            "Setas: exploram o mapa, quadrado por quadrado.",
            "Flechas: exploran el mapa, cuadro por cuadro.",
        ),
        (
            "N and P: the next thing and the one before. Home: back to Donnie.",
            "N e P: a próxima coisa e a anterior. Home: de volta ao Donnie.",
            "N y P: la cosa siguiente y la anterior. Inicio: de vuelta a Donnie.",
        ),
        (
            "F: marks the square. W: tells the way from the mark.",
            "F: marca o quadrado. W: diz o caminho desde a marca.",
            "F: marca el cuadro. W: dice el camino desde la marca.",
        ),
        (
            "Plus and minus: nearer and farther. A: all of the map, or follow Donnie.",
            "Mais e menos: mais perto e mais longe. A: o mapa inteiro, ou seguir o Donnie.",
            "Más y menos: más cerca y más lejos. A: todo el mapa, o seguir a Donnie.",
        ),
        (
            "T: names. C: coordinates. L: what the letters mean.",
            "T: nomes. C: coordenadas. L: o que as letras significam.",
            "T: nombres. C: coordenadas. L: qué significan las letras.",
        ),
    ),
    "variables": (
        ("In the variables:", "Nas variáveis:", "En las variables:"),
        (
            "Up and Down, Page Up and Page Down, Home and End: read the lines.",
            "Setas, Page Up e Page Down, Home e End: leem as linhas.",
            "Flechas, Re Pág y Av Pág, Inicio y Fin: leen las líneas.",
        ),
    ),
    "log": (
        ("In the log:", "No registro:", "En el registro:"),
        (
            "Up and Down, Page Up and Page Down: read what was said. End: the newest line.",
            "Setas, Page Up e Page Down: leem o que foi dito. End: a linha mais nova.",
            "Flechas, Re Pág y Av Pág: leen lo que se dijo. Fin: la línea más nueva.",
        ),
    ),
    "command": (
        ("In the command line:", "Na linha de comando:", "En la línea de comandos:"),
        (
            "Type a command of GoDonnie or a word of the help; Enter does it.",
            "Digite um comando de GoDonnie ou uma palavra da ajuda; Enter executa.",
            "Escribe un comando de GoDonnie o una palabra de la ayuda; Enter lo hace.",
        ),
        (
            "Up and Down: what was typed before.",
            "Seta acima e abaixo: o que foi digitado antes.",
            "Arriba y abajo: lo que se escribió antes.",
        ),
    ),
}


def _here() -> dict[str, Sentence]:
    return {
        f"here-{pane}-{number}" if number else f"here-{pane}": Sentence(*texts)
        for pane, lines in _HERE.items()
        for number, texts in enumerate(lines)
    }


SENTENCES: dict[str, Sentence] = _here() | {
    "here-key": Sentence("{keys}: {purpose}", "{keys}: {purpose}", "{keys}: {purpose}"),
    "menu-no-key": Sentence("{key} does nothing.", "{key} não faz nada.", "{key} no hace nada."),
    "esc-again": Sentence(
        "It is closed already. Esc again: {word}.",
        "Já está fechado. Esc de novo: {word}.",
        "Ya está cerrado. Esc otra vez: {word}.",
    ),
    "here-tab": Sentence(
        "Tab: the next pane. Shift+Tab: the one before.",
        "Tab: o próximo painel. Shift+Tab: o anterior.",
        "Tab: el panel siguiente. Mayús+Tab: el anterior.",
    ),
    "action-keys_here": Sentence(
        "Tells the keys of this pane.", "Diz as teclas daqui.", "Dice las teclas de aquí."
    ),
    "action-change_keys": Sentence(
        "Gives an action another key.", "Dá outra tecla a uma ação.", "Da otra tecla a una acción."
    ),
    # --- changing them
    "keys-title": Sentence("Keys", "Teclas", "Teclas"),
    "keys-row": Sentence(
        "{word}: {keys}. {purpose}", "{word}: {keys}. {purpose}", "{word}: {keys}. {purpose}"
    ),
    "keys-none": Sentence("no key", "nenhuma tecla", "ninguna tecla"),
    "keys-as-before": Sentence(
        "All keys as they came", "Todas as teclas como eram", "Todas las teclas como eran"
    ),
    "keys-ask": Sentence(
        "Press the key for {word}.", "Aperte a tecla para {word}.", "Pulsa la tecla para {word}."
    ),
    "keys-behind": Sentence(
        "Now the key that comes behind Ctrl+K.",
        "Agora a tecla que vem depois de Ctrl+K.",
        "Ahora la tecla que viene detrás de Ctrl+K.",
    ),
    "keys-capture": Sentence(
        "Esc goes back, Backspace takes the chosen key away",
        "Esc volta, Backspace tira a tecla escolhida",
        "Esc vuelve, Retroceso quita la tecla elegida",
    ),
    "keys-not-this": Sentence(
        "{key} is needed for typing. F keys, Ctrl and Alt are free, and Ctrl+K with a letter.",
        "{key} é usada para digitar. Servem teclas F, Ctrl e Alt, e Ctrl+K com uma letra.",
        "{key} se usa para escribir. Sirven teclas F, Ctrl y Alt, y Ctrl+K con una letra.",
    ),
    "keys-now": Sentence("{row}.", "{row}.", "{row}."),
    "keys-not-understood": Sentence(
        "Keys of the settings: {entry} means nothing.",
        "Teclas da configuração: {entry} não quer dizer nada.",
        "Teclas de la configuración: {entry} no significa nada.",
    ),
    "setting-keys-none": Sentence("as they came", "como eram", "como eran"),
    # --- each sound
    "setting-cues": Sentence("Sounds, each", "Sons, cada um", "Sonidos, cada uno"),
    "setting-cues-none": Sentence("all on", "todos ligados", "todos encendidos"),
    "setting-cues-wanted": Sentence(
        "A sound and a number from 0 to 100, such as bump 50:",
        "Um som e um número de 0 a 100, como colisão 50:",
        "Un sonido y un número de 0 a 100, como choque 50:",
    ),
    "cue-row": Sentence(
        "{name}: {meaning}. {volume}", "{name}: {meaning}. {volume}", "{name}: {meaning}. {volume}"
    ),
    "cue-volume": Sentence("Volume {percent}.", "Volume {percent}.", "Volumen {percent}."),
    "cue-volume-off": Sentence("Off.", "Desligado.", "Apagado."),
    "setting-key_echo": Sentence("Typing is said", "O que se digita é dito", "Lo que se escribe se dice"),
    "value-key_echo-none": Sentence("no", "não", "no"),
    "value-key_echo-characters": Sentence("letters", "letras", "letras"),
    "value-key_echo-words": Sentence("words", "palavras", "palabras"),
}
