package org.dronewatch.docs;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.House;
import org.dronewatch.House.Storey;

/** Draws the packages storey by storey: an SVG that cannot disagree with the rules of the build. */
final class HouseDrawing {
    private static final int CAPTIONS = 130;
    private static final int WIDTH = 860;
    private static final int STEP = 38;
    private static final int ROOM = 28;
    private static final int GAP = 8;

    private HouseDrawing() {}

    static String write() {
        List<String> lines = new ArrayList<>();
        int height = STEP * House.STOREYS.size() + 2 * GAP;
        lines.add(String.format(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" "
                        + "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"14\">",
                WIDTH + 2 * GAP, height, WIDTH + 2 * GAP, height));
        lines.add("<title>The packages of dronewatch: each may use those below it</title>");
        lines.add("<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>");
        int y = GAP;
        for (Storey storey : House.STOREYS) {
            add(storey, y, lines);
            y += STEP;
        }
        lines.add("</svg>");
        return String.join("\n", lines) + "\n";
    }

    private static void add(Storey storey, int y, List<String> lines) {
        if (!storey.caption().isEmpty()) {
            lines.add(String.format(
                    "<line x1=\"%d\" y1=\"%d\" x2=\"%d\" y2=\"%d\" stroke=\"#c8d0da\"/>",
                    GAP, y - GAP / 2, WIDTH + GAP, y - GAP / 2));
            lines.add(
                    String.format("<text x=\"%d\" y=\"%d\" fill=\"#5a6675\">%s</text>", GAP, y + 19, storey.caption()));
        }
        int rooms = storey.rooms().size();
        int width = (WIDTH - CAPTIONS - GAP * (rooms - 1)) / rooms;
        for (int i = 0; i < rooms; i++) {
            int x = GAP + CAPTIONS + i * (width + GAP);
            lines.add(String.format(
                    "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" rx=\"4\" fill=\"#e8eff8\" stroke=\"#7d98b8\"/>",
                    x, y, width, ROOM));
            lines.add(String.format(
                    "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\" fill=\"#1d2b3a\">%s</text>",
                    x + width / 2, y + 19, storey.rooms().get(i).replace("..", "")));
        }
    }
}
