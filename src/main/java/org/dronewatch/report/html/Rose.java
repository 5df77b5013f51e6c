package org.dronewatch.report.html;

import static org.dronewatch.report.html.ReadableNumbers.format;
import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.List;

/** A drawing of values versus bearing, north up: rings at round values, a closed line for each series, a legend. */
public final class Rose {
    /** The number of legend entries for which there is room. */
    public static final int ENTRIES = 18;

    private static final int WIDTH = 860;
    private static final int HEIGHT = 560;
    private static final double X = 280.0;
    private static final double Y = 280.0;
    private static final double RADIUS = 235.0;
    private static final int LEGEND = 570;
    private static final int LINE = 24;
    private static final String[] NAMES = {"N", "NE", "E", "SE", "S", "SW", "W", "NW"};

    private final double most;
    private final String unit;
    private final StringBuilder svg = new StringBuilder();

    /** The labels of the rings, which are drawn last, so that no line crosses them. */
    private final StringBuilder labels = new StringBuilder();

    private double entry = 60.0;

    /**
     * A value of a series.
     *
     * @param bearing rad clockwise from north
     * @param value 0 or more
     */
    public record Point(double bearing, double value) {}

    /**
     * An empty rose.
     *
     * @param label describes the drawing, for readers who cannot see it
     * @param most the value at the rim, above 0
     * @param unit unit of the values
     */
    public Rose(String label, double most, String unit) {
        this.most = most;
        this.unit = unit;
        svg.append(format(
                "<div class=\"wide\"><svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" role=\"img\""
                        + " aria-label=\"%s\">%n",
                WIDTH, HEIGHT, Html.text(label)));
    }

    /** The short name of one of the eight principal compass points, counted clockwise from 0 at north. */
    public static String name(int sector) {
        return NAMES[sector];
    }

    /**
     * Draws a circle at a value.
     *
     * @param style attributes of the element
     */
    public void circle(double value, String style) {
        svg.append(format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" %s/>%n", X, Y, radius(value), style));
    }

    private double radius(double value) {
        return RADIUS * value / most;
    }

    /** Draws rings at round values, and lines and labels for the compass points. */
    public void scale() {
        double wanted = most / 4.0;
        double power = Math.pow(10.0, Math.floor(Math.log10(wanted)));
        double step = wanted <= 2 * power ? 2 * power : wanted <= 5 * power ? 5 * power : 10 * power;
        for (int i = 1; i * step <= most * (1.0 + 1e-9); i++) {
            circle(i * step, "fill=\"none\" stroke=\"#b8bec5\"");
            labels.append(format(
                    "<text x=\"%.1f\" y=\"%.1f\" stroke=\"#fff\" stroke-width=\"4\" paint-order=\"stroke\">%s</text>%n",
                    X + 4, Y - radius(i * step) - 3, Html.text(number(i * step) + " " + unit)));
        }
        circle(most, "fill=\"none\" stroke=\"#667\"");
        for (int i = 0; i < NAMES.length; i++) {
            double bearing = 2.0 * Math.PI * i / NAMES.length;
            svg.append(format(
                    "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"#dfe3e7\"/>%n",
                    X, Y, X + RADIUS * Math.sin(bearing), Y - RADIUS * Math.cos(bearing)));
            double outside = RADIUS + 20.0;
            text(X + outside * Math.sin(bearing), Y - outside * Math.cos(bearing) + 4.0, "middle", NAMES[i]);
        }
    }

    /**
     * Draws a closed line.
     *
     * @param points points in the order of their bearings
     * @param stroke attributes of the line
     */
    public void line(List<Point> points, String stroke) {
        StringBuilder corners = new StringBuilder();
        for (Point one : points) {
            corners.append(format("%.1f,%.1f ", x(one), y(one)));
        }
        svg.append(format(
                "<polygon points=\"%s\" fill=\"none\" %s/>%n",
                corners.toString().strip(), stroke));
    }

    /** Draws a dot at a value. */
    public void dot(Point point, String fill) {
        svg.append(format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\"/>%n", x(point), y(point), fill));
    }

    private double x(Point point) {
        return X + radius(point.value()) * Math.sin(point.bearing());
    }

    private double y(Point point) {
        return Y - radius(point.value()) * Math.cos(point.bearing());
    }

    /**
     * Adds an entry to the legend.
     *
     * @param stroke attributes of the line that the entry explains
     */
    public void entry(String stroke, String words) {
        svg.append(format(
                "<line x1=\"%d\" y1=\"%.1f\" x2=\"%d\" y2=\"%.1f\" %s/>%n", LEGEND, entry, LEGEND + 44, entry, stroke));
        text(LEGEND + 54.0, entry + 4.0, "start", words);
        entry += LINE;
    }

    private void text(double x, double y, String anchor, String words) {
        svg.append(
                format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">%s</text>%n", x, y, anchor, Html.text(words)));
    }

    /** The drawing as mark-up. */
    public String svg() {
        return svg.toString() + labels + "</svg></div>\n";
    }
}
