package org.dronewatch.report.coverage;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.awt.Color;
import java.util.List;
import java.util.Locale;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.field.Warning;
import org.dronewatch.report.html.Html;

/** The warning of straight inbound flights as a rose: a line for each height, and the required response as a ring. */
final class WarningRose {
    private static final int WIDTH = 860;
    private static final int HEIGHT = 560;
    private static final double X = 280.0;
    private static final double Y = 280.0;
    private static final double RADIUS = 235.0;
    private static final int LEGEND = 570;
    private static final int LINE = 24;

    private final InboundWarnings warnings;
    private final double[] heights;
    private final double most;

    WarningRose(InboundWarnings warnings) {
        this.warnings = warnings;
        this.heights = WarningTable.heights(warnings);
        double longest = warnings.all().stream()
                .mapToDouble(one -> one.time().orElse(0.0))
                .max()
                .orElse(0.0);
        // Above 0 even if no drone is detected at all, so that there is a scale.
        this.most = Math.max(1.0, Math.max(longest, 1.1 * warnings.response()));
    }

    /** The drawing. */
    String svg() {
        StringBuilder svg = new StringBuilder();
        svg.append(format(
                "<div class=\"wide\"><svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" role=\"img\""
                        + " aria-label=\"warning by bearing and height\">%n",
                WIDTH, HEIGHT));
        if (warnings.response() > 0.0) {
            svg.append(circle(warnings.response(), "fill=\"#f3e3dc\" stroke=\"none\""));
        }
        scale(svg);
        for (int i = 0; i < heights.length; i++) {
            line(svg, i);
        }
        if (warnings.response() > 0.0) {
            svg.append(circle(warnings.response(), "fill=\"none\" stroke=\"#000\" stroke-width=\"3\""));
        }
        legend(svg);
        return svg.append("</svg></div>\n").toString();
    }

    private String circle(double time, String style) {
        return format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" %s/>%n", X, Y, radius(time), style);
    }

    private double radius(double time) {
        return RADIUS * time / most;
    }

    /** Rings at round times, and the bearings. */
    private void scale(StringBuilder svg) {
        double wanted = most / 4.0;
        double power = Math.pow(10.0, Math.floor(Math.log10(wanted)));
        double step = wanted <= 2 * power ? 2 * power : wanted <= 5 * power ? 5 * power : 10 * power;
        for (int i = 1; i * step <= most * (1.0 + 1e-9); i++) {
            svg.append(circle(i * step, "fill=\"none\" stroke=\"#b8bec5\""));
            svg.append(text(X + 4, Y - radius(i * step) - 3, "start", number(i * step) + " s"));
        }
        svg.append(circle(most, "fill=\"none\" stroke=\"#667\""));
        String[] names = {"N", "NE", "E", "SE", "S", "SW", "W", "NW"};
        for (int i = 0; i < names.length; i++) {
            double bearing = 0.25 * Math.PI * i;
            svg.append(format(
                    "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"#dfe3e7\"/>%n",
                    X, Y, X + RADIUS * Math.sin(bearing), Y - RADIUS * Math.cos(bearing)));
            double outside = RADIUS + 20.0;
            svg.append(
                    text(X + outside * Math.sin(bearing), Y - outside * Math.cos(bearing) + 4.0, "middle", names[i]));
        }
    }

    private void line(StringBuilder svg, int number) {
        StringBuilder points = new StringBuilder();
        for (Warning one : its(number)) {
            double radius = radius(one.time().orElse(0.0));
            points.append(
                    format("%.1f,%.1f ", X + radius * Math.sin(one.bearing()), Y - radius * Math.cos(one.bearing())));
        }
        svg.append(format(
                "<polygon points=\"%s\" fill=\"none\" %s/>%n", points.toString().strip(), stroke(number)));
    }

    private List<Warning> its(int number) {
        return warnings.all().stream()
                .filter(one -> one.height() == heights[number])
                .toList();
    }

    /** Lines differ in black and white, too: by their dashes. */
    private String stroke(int number) {
        Color colour = FieldPictures.ofHeight(number, heights.length);
        return format(
                "stroke=\"#%06x\" stroke-width=\"2.5\" stroke-dasharray=\"%d 4\"",
                colour.getRGB() & 0xffffff, 4 * (number + 1));
    }

    private void legend(StringBuilder svg) {
        double y = 60.0;
        for (int i = 0; i < heights.length && y < HEIGHT - 3 * LINE; i++, y += LINE) {
            svg.append(format(
                    "<line x1=\"%d\" y1=\"%.1f\" x2=\"%d\" y2=\"%.1f\" %s/>%n", LEGEND, y, LEGEND + 44, y, stroke(i)));
            svg.append(text(LEGEND + 54.0, y + 4.0, "start", number(heights[i]) + " m above the ground"));
        }
        if (warnings.response() > 0.0) {
            svg.append(format(
                    "<line x1=\"%d\" y1=\"%.1f\" x2=\"%d\" y2=\"%.1f\" stroke=\"#000\" stroke-width=\"3\"/>%n",
                    LEGEND, y, LEGEND + 44, y));
            svg.append(
                    text(LEGEND + 54.0, y + 4.0, "start", "required response, " + number(warnings.response()) + " s"));
        }
    }

    private static String text(double x, double y, String anchor, String words) {
        return format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">%s</text>%n", x, y, anchor, Html.text(words));
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
