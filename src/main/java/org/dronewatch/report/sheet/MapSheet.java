package org.dronewatch.report.sheet;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Polygon;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.Credits;
import org.dronewatch.report.html.Figure;
import org.dronewatch.world.World;

/** A map of a grid's area, north up: coloured cells over shaded ground, with a scale bar, and a legend beside it. */
public final class MapSheet {
    /** Width and height of the map itself, pixels. */
    public static final int MAP = 1000;

    private static final int SIDE = 400;
    private static final int MARGIN = 24;
    private static final int LINE = 26;
    private static final int SMALL_LINE = 16;
    private static final int SWATCH_WIDTH = 22;
    private static final int SWATCH_HEIGHT = 16;
    private static final Font TITLE = new Font(Font.SANS_SERIF, Font.BOLD, 19);
    private static final Font TEXT = new Font(Font.SANS_SERIF, Font.PLAIN, 15);
    private static final Font SMALL = new Font(Font.SANS_SERIF, Font.PLAIN, 12);

    private final BufferedImage image = new BufferedImage(MAP + SIDE, MAP, BufferedImage.TYPE_INT_RGB);
    private final Graphics2D g = image.createGraphics();
    private final FieldGrid grid;
    private final double side;
    private String caption = "";
    private boolean showsSensors;
    private int line = MARGIN + 16;

    /**
     * What fills a cell or a swatch of the legend. The colour depends on the position of the pixel, so a fill may be a
     * pattern.
     */
    public interface Fill {
        /**
         * The colour of a pixel of a cell or swatch, over that of the ground below it: red, green and blue in the
         * lowest 24 bits. Its column and row are counted from the top left corner of the map or swatch.
         */
        int at(int u, int v, int ground);
    }

    /** The fill of each cell. */
    public interface Cells {
        /** The fill of a cell, given by its column from the west and its row from the north. */
        Fill at(int column, int row);
    }

    /** An empty sheet for the area of a grid. */
    public MapSheet(FieldGrid grid) {
        this.grid = grid;
        this.side = grid.columns() * grid.cell();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(Color.WHITE);
        g.fillRect(MAP, 0, SIDE, MAP);
    }

    /**
     * The shaded ground of a grid's area, which is the same on all maps of that area: red, green and blue of each
     * pixel, row by row from the north-west.
     */
    public static int[] ground(World world, FieldGrid grid) {
        return ReliefShade.of(world, grid.east(), grid.north(), grid.columns() * grid.cell(), MAP);
    }

    /**
     * Draws the cells, the sensors, the scale bar and the north arrow.
     *
     * @param ground the shaded ground, as {@link #ground} returns it
     */
    public void drawMap(int[] ground, Cells cells, List<Position> sensors) {
        for (int v = 0; v < MAP; v++) {
            for (int u = 0; u < MAP; u++) {
                Fill fill = cells.at(u * grid.columns() / MAP, v * grid.columns() / MAP);
                image.setRGB(u, v, fill.at(u, v, ground[v * MAP + u]));
            }
        }
        sensors.forEach(this::drawSensor);
        frame();
    }

    /** Draws the scale bar and the north arrow again, on top of anything drawn over them. */
    public void frame() {
        MapFrame.draw(g, MAP, side);
    }

    private int column(Position at) {
        return (int) Math.round((at.x() - grid.east()) / side * MAP + 0.5 * MAP);
    }

    private int row(Position at) {
        return (int) Math.round(0.5 * MAP - (at.y() - grid.north()) / side * MAP);
    }

    /** Draws a closed line on the map. */
    public void outline(List<Position> corners, Color colour) {
        outline(corners, colour, MapMarks.SOLID);
    }

    /** Draws a closed line on the map, one of several that may coincide. */
    public void outline(List<Position> corners, LineLayer layer) {
        outline(corners, LineLayer.EDGE, layer.edge());
        outline(corners, layer.colour(), layer.stroke());
    }

    private void outline(List<Position> corners, Color colour, BasicStroke stroke) {
        Polygon line = new Polygon();
        corners.forEach(corner -> line.addPoint(column(corner), row(corner)));
        draw(line, colour, stroke);
    }

    /**
     * Draws an open line on the map.
     *
     * @param width pixels
     */
    public void draw(List<Position> points, Color colour, float width) {
        draw(points, colour, new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    }

    /** Draws black dashes over an open line on the map. */
    public void dashes(List<Position> points) {
        draw(points, Color.BLACK, MapMarks.DASHES);
    }

    private void draw(List<Position> points, Color colour, BasicStroke stroke) {
        Path2D path = new Path2D.Double();
        path.moveTo(column(points.get(0)), row(points.get(0)));
        points.forEach(point -> path.lineTo(column(point), row(point)));
        draw(path, colour, stroke);
    }

    private void draw(Shape line, Color colour, BasicStroke stroke) {
        g.setClip(0, 0, MAP, MAP);
        g.setColor(colour);
        g.setStroke(stroke);
        g.draw(line);
        g.setClip(null);
    }

    /** Writes a short text on a pale background near a point on the map, clear of the edge, scale bar and arrow. */
    public void label(Position at, String text) {
        g.setFont(TITLE);
        int wide = g.getFontMetrics().stringWidth(text);
        int u = Math.max(MARGIN / 2, Math.min(MAP - wide - MARGIN / 2, column(at) - wide / 2));
        int v = Math.max(LINE, Math.min(MAP - MARGIN / 2, row(at) - MARGIN / 2));
        Rectangle box = MapFrame.beside(new Rectangle(u - 5, v - 18, wide + 10, 24), MAP, side);
        g.setColor(new Color(255, 255, 255, 220));
        g.fillRoundRect(box.x, box.y, box.width, box.height, 8, 8);
        g.setColor(Color.BLACK);
        g.drawString(text, box.x + 5, box.y + 18);
        g.setFont(TEXT);
    }

    /** Marks a point on the map with a white square. */
    public void square(Position at) {
        MapMarks.square(g, column(at), row(at));
    }

    /** Writes a legend entry, preceded by a white square. */
    public void squareSample(String text) {
        MapMarks.square(g, MAP + MARGIN + SWATCH_WIDTH, line - 5);
        write(text, MAP + MARGIN + 2 * SWATCH_WIDTH + 12);
    }

    /** Writes a legend entry, preceded by a sample of a line with a black edge; the width is in pixels. */
    public void sample(Color colour, float width, String text) {
        drawSample(Color.BLACK, new BasicStroke(width + 2f), 0);
        sample(colour, new BasicStroke(width), 1, text);
    }

    /** Writes a legend entry, preceded by a sample of a line. */
    public void sample(Color colour, String text) {
        sample(colour, MapMarks.SOLID, 0, text);
    }

    /** Writes a legend entry, preceded by a sample of black dashes. */
    public void sampleDashes(String text) {
        sample(Color.BLACK, MapMarks.DASHES, 0, text);
    }

    /** Writes a legend entry, preceded by a sample of a line, one of several that may coincide. */
    public void sample(LineLayer layer, String text) {
        sample(layer.colour(), layer.stroke(), 0, text);
    }

    private void sample(Color colour, BasicStroke stroke, int inset, String text) {
        drawSample(colour, stroke, inset);
        write(text, MAP + MARGIN + 2 * SWATCH_WIDTH + 12);
    }

    private void drawSample(Color colour, BasicStroke stroke, int inset) {
        g.setColor(colour);
        g.setStroke(stroke);
        g.drawLine(MAP + MARGIN + inset, line - 5, MAP + MARGIN + 2 * SWATCH_WIDTH - inset, line - 5);
    }

    private void drawSensor(Position at) {
        if (new Rectangle(MAP, MAP).contains(column(at), row(at))) {
            MapMarks.dot(g, column(at), row(at));
            showsSensors = true;
        }
    }

    /** Explains the dots of sensors in the legend, if there are any on the map. */
    public void explainSensors() {
        if (showsSensors) {
            MapMarks.dot(g, MAP + MARGIN + SWATCH_WIDTH / 2, line - SWATCH_HEIGHT / 2 + 2);
            write("sensor", MAP + MARGIN + SWATCH_WIDTH + 12);
        }
    }

    /** Writes the credits required by the site's data at the bottom of the legend. */
    public void credits(List<String> credits) {
        g.setFont(SMALL);
        g.setColor(Color.DARK_GRAY);
        List<String> lines = Credits.lines(credits, g.getFontMetrics(), SIDE - 2 * MARGIN);
        for (int i = 0; i < lines.size(); i++) {
            g.drawString(lines.get(i), MAP + MARGIN, MAP - MARGIN - SMALL_LINE * (lines.size() - 1 - i));
        }
    }

    /** Writes the title of the legend. */
    public void title(String text) {
        g.setFont(TITLE);
        write(text, MAP + MARGIN);
        g.setFont(TEXT);
    }

    /** Writes a line of the legend. */
    public void line(String text) {
        write(text, MAP + MARGIN);
    }

    /** Writes a text in as many lines as it needs. */
    private void write(String text, int x) {
        g.setColor(Color.BLACK);
        line = LegendText.draw(g, text, x, line, image.getWidth() - MARGIN / 2 - x) + LINE;
    }

    /** Leaves half a line blank. */
    public void space() {
        line += LINE / 2;
    }

    /** Writes a legend entry, preceded by a swatch. */
    public void entry(Fill fill, String text) {
        int left = MAP + MARGIN;
        int top = line - SWATCH_HEIGHT + 2;
        for (int v = 0; v < SWATCH_HEIGHT; v++) {
            for (int u = 0; u < SWATCH_WIDTH; u++) {
                image.setRGB(left + u, top + v, fill.at(u, v, 0xd8d4cc));
            }
        }
        g.setColor(Color.DARK_GRAY);
        g.setStroke(new BasicStroke(1f));
        g.drawRect(left, top, SWATCH_WIDTH, SWATCH_HEIGHT);
        write(text, left + SWATCH_WIDTH + 12);
    }

    /** The colour of a pixel; columns and rows are counted from the top left. */
    public Color colour(int column, int row) {
        return new Color(image.getRGB(column, row));
    }

    /** Sets the caption of the map in a report: a sentence that states what the map shows. */
    public void caption(String sentence) {
        caption = sentence;
    }

    /** The sheet as a figure of a report. */
    public Figure figure() throws IOException {
        return Figure.of(caption, image);
    }

    /** Writes the sheet as PNG. */
    public void writePng(OutputStream target) throws IOException {
        try (ImageOutputStream stream = new MemoryCacheImageOutputStream(target)) {
            ImageIO.write(image, "png", stream);
        }
    }
}
