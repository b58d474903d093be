"""What each command is for, one short sentence each; their forms and examples are in ``i18n.help``."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    "help-list": Sentence(
        "{count} commands. {help} and a word tells more.",
        "{count} comandos. {help} e uma palavra diz mais.",
        "{count} comandos. {help} y una palabra dice más.",
        brief=(
            "{count} commands. {help} and a word.",
            "{count} comandos. {help} e uma palavra.",
            "{count} comandos. {help} y una palabra.",
        ),
    ),
    "help-purpose": Sentence("{word}: {purpose}", "{word}: {purpose}", "{word}: {purpose}"),
    "help-form": Sentence("Form: {form}", "Forma: {form}", "Forma: {form}"),
    "help-or": Sentence("{first}, or {second}", "{first}, ou {second}", "{first}, o {second}"),
    "help-example": Sentence("Example: {example}", "Exemplo: {example}", "Ejemplo: {example}"),
    "help-unknown": Sentence(
        "I do not know {topic}. {help} lists the commands.",
        "Não conheço {topic}. {help} lista os comandos.",
        "No conozco {topic}. {help} lista los comandos.",
    ),
    "help-unknown-near": Sentence(
        "I do not know {topic}. Did you mean {near}?",
        "Não conheço {topic}. Você quis dizer {near}?",
        "No conozco {topic}. Quizá querías decir {near}.",
    ),
    # --- the words in a form that stand for something else
    "form-commands": Sentence("commands", "comandos", "comandos"),
    "form-condition": Sentence("condition", "condição", "condición"),
    "form-value": Sentence("value", "valor", "valor"),
    "form-name": Sentence("name", "nome", "nombre"),
    "form-hello": Sentence("hello", "oi", "hola"),
    "form-text": Sentence("text", "texto", "texto"),
    "form-colour": Sentence("colour", "cor", "color"),
    "form-direction": Sentence("direction", "direção", "dirección"),
    "form-word": Sentence("word", "palavra", "palabra"),
    # --- purposes
    "purpose-QUIT": Sentence("leaves Donnie.", "sai do Donnie.", "sale de Donnie."),
    "purpose-VAR": Sentence("makes a variable.", "cria uma variável.", "crea una variable."),
    "purpose-SPEAK": Sentence(
        "says a text or a number.", "fala um texto ou um número.", "dice un texto o un número."
    ),
    "purpose-SOUND": Sentence(
        "turns voice and sounds on or off.", "liga ou desliga voz e sons.", "enciende o apaga voz y sonidos."
    ),
    "purpose-FW": Sentence(
        "walks forward, in steps.", "anda para frente, em passos.", "camina adelante, en pasos."
    ),
    "purpose-BW": Sentence(
        "walks backward, in steps.", "anda para trás, em passos.", "camina atrás, en pasos."
    ),
    "purpose-TR": Sentence(
        "turns to the right, in degrees.", "gira para a direita, em graus.", "gira a la derecha, en grados."
    ),
    "purpose-TL": Sentence(
        "turns to the left, in degrees.", "gira para a esquerda, em graus.", "gira a la izquierda, en grados."
    ),
    "purpose-SCAN": Sentence(
        "tells what is ahead and beside.",
        "diz o que há à frente e ao lado.",
        "dice qué hay al frente y al lado.",
    ),
    "purpose-STATE": Sentence(
        "tells the last movement.", "diz o último movimento.", "dice el último movimiento."
    ),
    "purpose-DISTANCE": Sentence(
        "the steps to an obstacle.", "os passos até um obstáculo.", "los pasos hasta un obstáculo."
    ),
    "purpose-POS": Sentence("where the robot is.", "onde o robô está.", "dónde está el robot."),
    "purpose-COLOR": Sentence(
        "how many objects of a colour.", "quantos objetos de uma cor.", "cuántos objetos de un color."
    ),
    "purpose-WAIT": Sentence("waits some seconds.", "espera alguns segundos.", "espera unos segundos."),
    "purpose-HISTORY": Sentence(
        "tells all movements so far.", "diz todos os movimentos.", "dice todos los movimientos."
    ),
    "purpose-BELT": Sentence(
        "turns the belt on or off.", "liga ou desliga o cinto.", "enciende o apaga el cinturón."
    ),
    "purpose-VIBRATE": Sentence("one pulse of the belt.", "um pulso do cinto.", "un pulso del cinturón."),
    "purpose-HELP": Sentence(
        "lists the commands, explains one.",
        "lista os comandos, explica um.",
        "lista los comandos, explica uno.",
    ),
    "purpose-RUN": Sentence(
        "runs what was typed.", "executa o que foi digitado.", "ejecuta lo que se escribió."
    ),
    "purpose-IF": Sentence(
        "chooses by a condition.", "escolhe por uma condição.", "elige por una condición."
    ),
    "purpose-FOR": Sentence("counts and repeats.", "conta e repete.", "cuenta y repite."),
    "purpose-REPEAT": Sentence("repeats so many times.", "repete tantas vezes.", "repite tantas veces."),
    "purpose-WHILE": Sentence(
        "repeats while it is true.", "repete enquanto é verdade.", "repite mientras es verdad."
    ),
    "purpose-PROCEDURE": Sentence(
        "teaches a new command.", "ensina um comando novo.", "enseña un comando nuevo."
    ),
}
