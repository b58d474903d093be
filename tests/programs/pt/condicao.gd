CRIAR ação = 3
SE ação >= 3 ENTÃO
  PARA FRENTE ação
SENÃO
  PARA TRÁS ação
FIM SE
PARA x = 0; x < 1; x = x + 1 FAÇA
FIM PARA
