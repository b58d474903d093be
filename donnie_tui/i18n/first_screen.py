"""What the full screen says before all else is loaded. Imports nothing; the catalogue takes it from here."""

START = (
    "Screen reader? Type LINEAR and Enter.",
    "Leitor de tela? Digite LINEAR e Enter.",
    "¿Lector de pantalla? Escribe LINEAL y Enter.",
)
START_KEYS = (
    "{run} runs the program. {help} helps.",
    "{run} executa o programa. {help} ajuda.",
    "{run} ejecuta el programa. {help} ayuda.",
)
FAULT = (
    "Donnie failed and had to end; your program is kept: start again, type RECOVER and Enter.",
    "O Donnie falhou e teve que parar; seu programa está guardado: abra de novo, digite RECUPERAR e Enter.",
    "Donnie falló y tuvo que terminar; tu programa está guardado: vuelve a abrir, escribe RECUPERAR y Enter.",
)
PROGRAM = ("Program", "Programa", "Programa")
MAP = ("Map", "Mapa", "Mapa")
LOG = ("Log", "Registro", "Registro")
VARIABLES = ("Variables", "Variáveis", "Variables")
STARTING = ("Starting.", "Iniciando.", "Iniciando.")
ONE_MOMENT = (
    "One moment, Donnie is starting.",
    "Um momento, o Donnie está iniciando.",
    "Un momento, Donnie está iniciando.",
)
