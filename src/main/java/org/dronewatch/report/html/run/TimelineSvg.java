package org.dronewatch.report.html.run;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronewatch.render.canvas.KindColours;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.ReadableNumbers;
import org.dronewatch.run.DetectionIntervals;
import org.dronewatch.run.DetectionIntervals.Interval;
import org.dronewatch.run.RunResult;

/** The time line of a run: a row for each sensor, with a bar for each interval in which it detects a drone. */
final class TimelineSvg {
    private static final int WIDTH = 900;
    private static final int NAMES = 170;
    private static final int ROW = 22;
    private static final int AXIS = 34;

    private final RunResult run;
    private final KindColours colours;
    private final double duration;
    private final DetectionIntervals intervals;

    TimelineSvg(RunResult run) {
        this.run = run;
        this.colours = KindColours.of(run.settings().enabledSensors().values());
        this.duration = run.settings().run().duration();
        this.intervals = DetectionIntervals.of(run.events());
    }

    private double x(double time) {
        return NAMES + (WIDTH - NAMES - 20) * Math.min(1.0, time / duration);
    }

    /** The drawing. */
    String draw() {
        List<String> sensors = new ArrayList<>(run.settings().enabledSensors().keySet());
        int height = ROW * sensors.size() + AXIS;
        StringBuilder svg = new StringBuilder();
        svg.append(format(
                "<div class=\"wide\"><svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" role=\"img\" aria-label=\"timeline of"
                        + " detections\">%n",
                WIDTH, height));
        for (int row = 0; row < sensors.size(); row++) {
            row(svg, row, sensors.get(row));
        }
        axis(svg, ROW * sensors.size());
        return svg.append("</svg></div>\n").toString();
    }

    private void row(StringBuilder svg, int row, String sensor) {
        int top = row * ROW;
        Color colour = colours.of(run.settings().sensors().get(sensor).kind());
        svg.append(format(
                "<text x=\"%d\" y=\"%d\" text-anchor=\"end\">%s</text>%n",
                NAMES - 10, top + 15, Html.text(shortened(sensor))));
        svg.append(format(
                "<rect x=\"%.1f\" y=\"%d\" width=\"%.1f\" height=\"%d\" fill=\"#eef0f2\"/>%n",
                x(0), top + 3, x(run.simulated()) - x(0), ROW - 6));
        for (Interval held : intervals.ofSensor(sensor, run.simulated())) {
            bar(svg, top, held.from(), held.to(), colour);
        }
    }

    private void bar(StringBuilder svg, int top, double from, double to, Color colour) {
        svg.append(format(
                "<rect x=\"%.1f\" y=\"%d\" width=\"%.1f\" height=\"%d\" fill=\"#%06x\"/>%n",
                x(from), top + 3, Math.max(1.5, x(to) - x(from)), ROW - 6, colour.getRGB() & 0xffffff));
    }

    private void axis(StringBuilder svg, int top) {
        double wanted = duration / 8.0;
        double power = Math.pow(10.0, Math.floor(Math.log10(wanted)));
        double step = wanted <= 2 * power ? 2 * power : wanted <= 5 * power ? 5 * power : 10 * power;
        for (int i = 0; i * step <= duration * (1.0 + 1e-9); i++) {
            double x = x(i * step);
            svg.append(format(
                    "<line x1=\"%.1f\" y1=\"%d\" x2=\"%.1f\" y2=\"%d\" stroke=\"#667\"/>"
                            + "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%s s</text>%n",
                    x, top, x, top + 5, x, top + 20, ReadableNumbers.number(i * step)));
        }
    }

    private static String shortened(String name) {
        return name.length() <= 22 ? name : name.substring(0, 21) + "\u2026";
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
