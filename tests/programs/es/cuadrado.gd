-- camina en un cuadrado
REPETIR 4 VECES
  AV 2
  GD 90
FIN REPETIR
ESTADO
HABLAR "listo"
