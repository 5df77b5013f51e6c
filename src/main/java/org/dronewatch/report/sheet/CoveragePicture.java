package org.dronewatch.report.sheet;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.dronewatch.analysis.Coverage;
import org.dronewatch.analysis.CoverageGrid;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.render.Credits;
import org.dronewatch.render.canvas.KindColours;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.world.World;

/** A plan view of a site, north up: shaded ground, the area covered by the sensors of each kind, and the sensors. */
public final class CoveragePicture {
    private static final int MAP = 1000;
    private static final int SIDE = 380;
    private static final int MARGIN = 24;
    private static final int LINE = 26;
    private static final int SMALL_LINE = 15;
    private static final int DECIMALS = 3;
    /** Stripes mark what is not known: they differ from every colour, in print as well. */
    private static final int STRIPE = 5;
    /** Width of the line around what a kind reaches, pixels. */
    private static final int EDGE = 2;

    private static final Color UNKNOWN = new Color(0x6b6b6b);
    private static final Font TITLE = new Font(Font.SANS_SERIF, Font.BOLD, 19);
    private static final Font SMALL = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
    private static final Font TEXT = new Font(Font.SANS_SERIF, Font.PLAIN, 15);

    private final Coverage coverage;
    private final CoverageGrid grid;
    private final KindColours colours;
    private final BufferedImage image = new BufferedImage(MAP + SIDE, MAP, BufferedImage.TYPE_INT_RGB);

    private CoveragePicture(Coverage coverage) {
        this.coverage = coverage;
        this.grid = coverage.grid();
        this.colours = KindColours.of(coverage.sensors().values());
    }

    /**
     * Draws a plan.
     *
     * @param title what the plan shows
     * @param world the world, for shading the ground
     * @param drone description of the drone for the legend
     * @param credits credits that the data of the site require
     */
    public static CoveragePicture of(String title, Coverage coverage, World world, String drone, List<String> credits) {
        CoveragePicture picture = new CoveragePicture(coverage);
        picture.drawMap(world);
        Graphics2D g = picture.image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        picture.drawSensors(g);
        MapFrame.draw(g, MAP, picture.grid.side());
        picture.drawLegend(g, title, drone, picture.drawCredits(g, credits));
        g.dispose();
        return picture;
    }

    /** The colour of a pixel; columns and rows are counted from the top left. */
    public Color colour(int column, int row) {
        return new Color(image.getRGB(column, row));
    }

    /** Writes the picture as PNG. */
    public void writePng(OutputStream target) throws IOException {
        try (ImageOutputStream stream = new MemoryCacheImageOutputStream(target)) {
            ImageIO.write(image, "png", stream);
        }
    }

    private void drawMap(World world) {
        int[] pixels = ReliefShade.of(world, grid.east(), grid.north(), grid.side(), MAP);
        int[] cells = IntStream.range(0, MAP).map(u -> u * grid.cells() / MAP).toArray();
        List<Layer> layers = colours.kinds().stream()
                .map(kind -> new Layer(
                        coverage.cellsOfKind(kind),
                        grid.cells(),
                        cells,
                        colours.of(kind).getRGB()))
                .toList();
        Workers.forEach(MAP, v -> {
            for (int u = 0; u < MAP; u++) {
                int pixel = v * MAP + u;
                if (coverage.isUnknown(cells[u], cells[v])) {
                    int stripe = (u + v) / STRIPE % 2 == 0 ? UNKNOWN.getRGB() : Color.WHITE.getRGB();
                    pixels[pixel] = ColourMix.of(pixels[pixel], stripe, 0.75);
                } else if (coverage.isReached(cells[u], cells[v])) {
                    for (Layer layer : layers) {
                        pixels[pixel] = layer.over(pixels[pixel], u, v);
                    }
                }
            }
        });
        image.getRaster().setDataElements(0, 0, MAP, MAP, pixels);
    }

    /**
     * The colour of a kind over the cells that its sensors reach, stronger at their edge.
     *
     * @param reached whether each cell is reached
     * @param columns number of columns of cells
     * @param cells column or row of the cell in which a pixel's column or row lies
     */
    private record Layer(boolean[] reached, int columns, int[] cells, int colour) {
        int over(int below, int u, int v) {
            return reaches(u, v) ? ColourMix.of(below, colour, isEdge(u, v) ? 0.9 : 0.33) : below;
        }

        private boolean isEdge(int u, int v) {
            return !(reaches(u - EDGE, v) && reaches(u + EDGE, v) && reaches(u, v - EDGE) && reaches(u, v + EDGE));
        }

        /** Whether the cell of a pixel is reached; no edge is drawn along the edge of the map. */
        private boolean reaches(int u, int v) {
            boolean isOutside = u < 0 || v < 0 || u >= MAP || v >= MAP;
            return isOutside || reached[cells[v] * columns + cells[u]];
        }
    }

    private void drawSensors(Graphics2D g) {
        coverage.sensors().forEach((id, sensor) -> {
            Position at = sensor.position();
            int u = (int) Math.round((at.x() - grid.east()) / grid.side() * MAP + 0.5 * MAP);
            int v = (int) Math.round(0.5 * MAP - (at.y() - grid.north()) / grid.side() * MAP);
            g.setColor(Color.WHITE);
            g.fillOval(u - 6, v - 6, 12, 12);
            g.setColor(colours.of(sensor.kind()));
            g.fillOval(u - 4, v - 4, 8, 8);
        });
    }

    /** Draws the credits at the bottom of the panel; returns their height. */
    private int drawCredits(Graphics2D g, List<String> credits) {
        g.setColor(Color.WHITE);
        g.fillRect(MAP, 0, SIDE, MAP);
        g.setColor(Color.DARK_GRAY);
        g.setFont(SMALL);
        List<String> lines = Credits.lines(credits, g.getFontMetrics(), SIDE - 2 * MARGIN);
        for (int i = 0; i < lines.size(); i++) {
            g.drawString(lines.get(i), MAP + MARGIN, MAP - MARGIN - SMALL_LINE * (lines.size() - 1 - i));
        }
        return SMALL_LINE * lines.size();
    }

    /** The rest of the panel, above the credits. */
    private void drawLegend(Graphics2D g, String title, String drone, int below) {
        int x = MAP + MARGIN;
        int y = MARGIN + 16;
        g.setColor(Color.BLACK);
        g.setFont(TITLE);
        y = LegendText.draw(g, title, x, y, SIDE - 2 * MARGIN);
        g.setFont(TEXT);
        for (String line : List.of(
                "detection of a drone flying " + plain(grid.height()) + " m",
                "above the surface below it, towards the",
                "sensor, with a probability of 0.5 or more;",
                drone,
                "cells of " + plain(grid.step()) + " m")) {
            y = LegendText.draw(g, line, x, y + LINE, SIDE - 2 * MARGIN);
        }
        y += LINE;
        for (String kind : colours.kinds()) {
            y += LINE;
            g.setColor(ColourMix.of(new Color(0xd8d4cc), colours.of(kind), 0.33));
            g.fillRect(x, y - 14, 22, 16);
            g.setColor(colours.of(kind));
            g.setStroke(new BasicStroke(2f));
            g.drawRect(x, y - 14, 22, 16);
            g.setColor(Color.BLACK);
            g.drawString(named(kind) + ": " + hectares(coverage.areaOfKind(kind)), x + 34, y);
        }
        double unknown = coverage.unknownArea();
        if (unknown > 0.0) {
            y += LINE;
            for (int v = 0; v < 16; v++) {
                for (int u = 0; u < 22; u++) {
                    boolean isDark = (u + v) / STRIPE % 2 == 0;
                    image.setRGB(x + u, y - 14 + v, (isDark ? UNKNOWN : Color.WHITE).getRGB());
                }
            }
            g.drawString("unknown ground: " + hectares(unknown), x + 34, y);
        }
        y += LINE;
        List<String> ids = new ArrayList<>(coverage.sensors().keySet());
        ids.removeIf(id -> idsOf(coverage.sensors().get(id).kind()).size() == 1);
        int room = Math.max(0, (MAP - y - MARGIN - below) / LINE - 1);
        for (String id : ids.subList(0, Math.min(room, ids.size()))) {
            y += LINE;
            g.setColor(colours.of(coverage.sensors().get(id).kind()));
            g.fillOval(x + 7, y - 9, 8, 8);
            g.setColor(Color.BLACK);
            g.drawString(shortened(id) + ": " + hectares(coverage.area(id)), x + 34, y);
        }
        if (ids.size() > room) {
            g.drawString("and " + (ids.size() - room) + " more", x + 34, y + LINE);
        }
    }

    /** The name of a kind, with that of its sensor if there is only one, whose area is then that of the kind. */
    private String named(String kind) {
        List<String> ids = idsOf(kind);
        return ids.size() > 1 || ids.get(0).equals(kind) ? kind : kind + ", " + shortened(ids.get(0));
    }

    private List<String> idsOf(String kind) {
        return coverage.sensors().entrySet().stream()
                .filter(sensor -> sensor.getValue().kind().equals(kind))
                .map(Map.Entry::getKey)
                .toList();
    }

    private static String shortened(String id) {
        return id.length() <= 24 ? id : id.substring(0, 23) + "\u2026";
    }

    /** A number to a thousandth, without zeros at the end. */
    private static String plain(double number) {
        return Numbers.rounded(number)
                .setScale(DECIMALS, RoundingMode.HALF_EVEN)
                .stripTrailingZeros()
                .toPlainString();
    }

    private static String hectares(double area) {
        return String.format(Locale.ROOT, "%.2f ha", 1e-4 * area);
    }
}
