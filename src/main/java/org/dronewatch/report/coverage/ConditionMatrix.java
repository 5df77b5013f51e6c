package org.dronewatch.report.coverage;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.dronewatch.analysis.survey.ConditionCoverage;
import org.dronewatch.report.coverage.table.ConditionTable;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.sheet.ColourMix;
import org.dronewatch.report.sheet.LegendText;

/**
 * A picture of the coverage under several conditions: a column for each, a row for each height, the highest on top.
 * Colours go from dark for nothing to light for everything, so that they keep their order in black and white and for
 * people with any kind of colour vision; the numbers are in the cells.
 */
final class ConditionMatrix {
    private static final Color NOTHING = new Color(0x2c4a86);
    private static final Color EVERYTHING = new Color(0xfff3c4);
    private static final Color UNKNOWN = new Color(0xe4e4e4);
    private static final int MARGIN = 24;
    private static final int LABELS = 90;
    private static final int CELL_WIDTH = 190;
    private static final int CELL_HEIGHT = 58;
    private static final int HEAD = 120;
    private static final int FOOT = 70;
    private static final double DARK = 0.5;
    private static final Font TITLE = new Font(Font.SANS_SERIF, Font.BOLD, 19);
    private static final Font TEXT = new Font(Font.SANS_SERIF, Font.PLAIN, 15);
    private static final Font NUMBER = new Font(Font.SANS_SERIF, Font.BOLD, 17);
    private static final Font SMALL = new Font(Font.SANS_SERIF, Font.PLAIN, 12);

    private final BufferedImage image;
    private final Graphics2D g;

    /**
     * Draws the picture.
     *
     * @param conditions the first is the scene as it is
     */
    ConditionMatrix(List<ConditionCoverage> conditions, CoverageInputs inputs) {
        int rows = conditions.get(0).heights().size();
        int width = Math.max(560, 2 * MARGIN + LABELS + conditions.size() * CELL_WIDTH);
        this.image = new BufferedImage(width, HEAD + rows * CELL_HEIGHT + FOOT, BufferedImage.TYPE_INT_RGB);
        this.g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(Color.WHITE);
        g.fillRect(0, 0, image.getWidth(), image.getHeight());
        write(TITLE, Color.BLACK, inputs.scene(), MARGIN, MARGIN + 14);
        write(
                TEXT,
                Color.BLACK,
                "% of the known cells covered, drone '" + inputs.drone() + "' " + inputs.headingInWords()
                        + inputs.within()
                                .map(time -> ", within " + inputs.timeInWords())
                                .orElse("")
                        + inputs.withProbability(),
                MARGIN,
                MARGIN + 42);
        for (int column = 0; column < conditions.size(); column++) {
            ConditionCoverage condition = conditions.get(column);
            centre(TEXT, Color.BLACK, ConditionTable.name(condition), left(column), HEAD - 12);
            for (int height = 0; height < rows; height++) {
                drawCell(condition.heights().get(height), left(column), top(height, rows));
            }
        }
        for (int height = 0; height < rows; height++) {
            String above = Numbers.text(
                            conditions.get(0).heights().get(height).summary().height())
                    + " m";
            write(TEXT, Color.BLACK, above, MARGIN, top(height, rows) + CELL_HEIGHT / 2 + 6);
        }
        drawScale(HEAD + rows * CELL_HEIGHT + 24);
    }

    private static int left(int column) {
        return MARGIN + LABELS + column * CELL_WIDTH;
    }

    private static int top(int height, int rows) {
        return HEAD + (rows - 1 - height) * CELL_HEIGHT;
    }

    private void drawCell(ConditionCoverage.Height height, int left, int top) {
        boolean isKnown = height.summary().known() > 0;
        Color ink = isKnown && height.share() < DARK ? Color.WHITE : Color.BLACK;
        g.setColor(isKnown ? ColourMix.of(NOTHING, EVERYTHING, height.share()) : UNKNOWN);
        g.fillRect(left, top, CELL_WIDTH - 2, CELL_HEIGHT - 2);
        if (!isKnown) {
            centre(SMALL, ink, "no known cells", left, top + 35);
            return;
        }
        String lost = height.lost() == 0 ? "" : "   lost " + ConditionTable.lost(height);
        String covered = ConditionTable.percent(height, height.summary().covered());
        centre(NUMBER, ink, (covered.equals("-") ? "0" : covered) + lost, left, top + 26);
        centre(SMALL, ink, ConditionTable.best(height), left, top + 45);
    }

    private void drawScale(int top) {
        int left = MARGIN + LABELS;
        int width = 240;
        for (int x = 0; x < width; x++) {
            g.setColor(ColourMix.of(NOTHING, EVERYTHING, (double) x / (width - 1)));
            g.fillRect(left + x, top, 1, 14);
        }
        write(SMALL, Color.BLACK, "0 %", left, top + 30);
        write(SMALL, Color.BLACK, "100 %", left + width - 34, top + 30);
        write(SMALL, Color.BLACK, "second line: the sensor that covers most, in %", left + width + 20, top + 12);
    }

    /** Writes a text, shortened if it would reach the edge. */
    private void write(Font font, Color ink, String text, int x, int y) {
        g.setFont(font);
        g.setColor(ink);
        g.drawString(LegendText.shortened(text, g.getFontMetrics(), image.getWidth() - MARGIN / 2 - x), x, y);
    }

    /** Writes a text at the centre of a cell, shortened if it is too long. */
    private void centre(Font font, Color ink, String text, int left, int y) {
        g.setFont(font);
        FontMetrics metrics = g.getFontMetrics();
        String shown = LegendText.shortened(text, metrics, CELL_WIDTH - 10);
        write(font, ink, shown, left + (CELL_WIDTH - 2 - metrics.stringWidth(shown)) / 2, y);
    }

    /** Writes the picture as PNG. */
    void writePng(OutputStream target) throws IOException {
        try (ImageOutputStream stream = new MemoryCacheImageOutputStream(target)) {
            ImageIO.write(image, "png", stream);
        }
    }
}
