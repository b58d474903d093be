"""The belt in words: what is felt, and what is wrong with it."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    "belt-felt": Sentence("Belt: {what}.", "Cinto: {what}.", "Cinturón: {what}."),
    "belt-nothing": Sentence("Belt: nothing near.", "Cinto: nada perto.", "Cinturón: nada cerca."),
    "belt-front": Sentence("front", "frente", "frente"),
    "belt-front_right": Sentence("front right", "frente direita", "frente derecha"),
    "belt-back_right": Sentence("back right", "trás direita", "atrás derecha"),
    "belt-back": Sentence("back", "trás", "atrás"),
    "belt-back_left": Sentence("back left", "trás esquerda", "atrás izquierda"),
    "belt-front_left": Sentence("front left", "frente esquerda", "frente izquierda"),
    "belt-weak": Sentence("weak", "fraco", "débil"),
    "belt-medium": Sentence("medium", "médio", "medio"),
    "belt-strong": Sentence("strong", "forte", "fuerte"),
    "belt-upper": Sentence("Upper row: {levels}.", "Fileira de cima: {levels}.", "Fila de arriba: {levels}."),
    "belt-lower": Sentence("Lower row: {levels}.", "Fileira de baixo: {levels}.", "Fila de abajo: {levels}."),
    "belt-missing": Sentence(
        "No belt at {port}: {reason}. I go on without.",
        "Sem cinto em {port}: {reason}. Continuo sem ele.",
        "Sin cinturón en {port}: {reason}. Sigo sin él.",
    ),
    "belt-found": Sentence("Belt connected.", "Cinto conectado.", "Cinturón conectado."),
    "belt-unanswered": Sentence(
        "What is at {port} does not answer as a belt.",
        "O que está em {port} não responde como um cinto.",
        "Lo que hay en {port} no responde como un cinturón.",
        brief=("No belt answers.", "Nenhum cinto responde.", "Ningún cinturón responde."),
    ),
    "belt-lost": Sentence("The belt is gone.", "O cinto sumiu.", "El cinturón no está."),
    "belt-restored": Sentence("The belt is back.", "O cinto voltou.", "El cinturón volvió."),
    "belt-same-port": Sentence(
        "Robot and belt can't both be at {port}.",
        "Robô e cinto não podem estar os dois em {port}.",
        "El robot y el cinturón no pueden estar los dos en {port}.",
        brief=(
            "Robot and belt are both at {port}.",
            "Robô e cinto estão os dois em {port}.",
            "Robot y cinturón están ambos en {port}.",
        ),
    ),
    "option-belt": Sentence("the port of the belt", "a porta do cinto", "el puerto del cinturón"),
    "belt-words-on": Sentence(
        "I tell what the belt shows.", "Digo o que o cinto mostra.", "Digo lo que muestra el cinturón."
    ),
    "belt-words-off": Sentence(
        "I no longer tell the belt.", "Não digo mais o cinto.", "Ya no digo el cinturón."
    ),
}
