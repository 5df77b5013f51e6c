package org.dronewatch.report.coverage;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.awt.Color;
import java.util.List;
import java.util.Locale;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.field.Warning;
import org.dronewatch.report.coverage.table.WarningTable;
import org.dronewatch.report.html.Rose;

/** The warning of straight inbound flights as a rose: a line for each height, and the required response as a ring. */
final class WarningRose {
    private static final String RESPONSE = "stroke=\"#000\" stroke-width=\"3\"";

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
        Rose rose = new Rose("warning by bearing and height", most, "s");
        if (warnings.response() > 0.0) {
            rose.circle(warnings.response(), "fill=\"#f3e3dc\" stroke=\"none\"");
        }
        rose.scale();
        for (int i = 0; i < heights.length; i++) {
            rose.line(points(i), stroke(i));
        }
        if (warnings.response() > 0.0) {
            rose.circle(warnings.response(), "fill=\"none\" " + RESPONSE);
        }
        for (int i = 0; i < heights.length && i < Rose.ENTRIES; i++) {
            rose.entry(stroke(i), number(heights[i]) + " m above the ground");
        }
        if (warnings.response() > 0.0) {
            rose.entry(RESPONSE, "response time, " + number(warnings.response()) + " s");
        }
        return rose.svg();
    }

    private List<Rose.Point> points(int number) {
        return its(number).stream()
                .map(one -> new Rose.Point(one.bearing(), one.time().orElse(0.0)))
                .toList();
    }

    private List<Warning> its(int number) {
        return warnings.all().stream()
                .filter(one -> one.height() == heights[number])
                .toList();
    }

    /** Lines differ in black and white, too: by their dashes. */
    private String stroke(int number) {
        Color colour = FieldPictures.ofHeight(number, heights.length);
        return String.format(
                Locale.ROOT,
                "stroke=\"#%06x\" stroke-width=\"2.5\" stroke-dasharray=\"%d 4\"",
                colour.getRGB() & 0xffffff,
                4 * (number + 1));
    }
}
