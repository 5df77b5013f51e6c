package org.dronewatch.report.campaign;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.ReadableNumbers;

/** Values as bars with their confidence intervals as whiskers. */
final class IntervalBars {
    private static final int WIDTH = 860;
    private static final double LEFT = 12.0;
    private static final double LENGTH = 820.0;
    private static final double ROW = 44.0;
    private static final double FOOT = 26.0;
    private static final int TICKS = 5;

    private final String label;
    private final double most;
    private final String unit;
    private final List<Bar> bars = new ArrayList<>();

    /**
     * A bar.
     *
     * @param words text above the bar
     * @param low lower end of its whisker; as high as the upper end if there is none
     * @param colour colour of the bar
     */
    private record Bar(String words, double value, double low, double high, String colour) {}

    /**
     * A drawing without bars yet.
     *
     * @param label what is shown, for those who cannot see it
     * @param most the end of the scale, above 0
     * @param unit unit of the values
     */
    IntervalBars(String label, double most, String unit) {
        this.label = label;
        this.most = most;
        this.unit = unit;
    }

    /** The end of a scale that reaches a value, 0 or more, and has its ticks at round values. */
    static double roundEnd(double most) {
        if (!(most > 0.0)) {
            return 1.0;
        }
        double power = Math.pow(10.0, Math.floor(Math.log10(most / TICKS)));
        for (double step : new double[] {1.0, 2.0, 5.0}) {
            if (step * power * TICKS >= most * (1.0 - 1e-9)) {
                return step * power * TICKS;
            }
        }
        return 10.0 * power * TICKS;
    }

    void add(String words, double value, double low, double high, String colour) {
        bars.add(new Bar(words, value, low, high, colour));
    }

    /** The drawing. */
    String svg() {
        double bottom = ROW * bars.size() + 4.0;
        StringBuilder svg = new StringBuilder(format(
                "<div class=\"wide\"><svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %.0f\" role=\"img\""
                        + " aria-label=\"%s\">%n",
                WIDTH, bottom + FOOT, Html.text(label)));
        for (int i = 0; i <= TICKS; i++) {
            double value = most * i / TICKS;
            svg.append(line(x(value), 0.0, x(value), bottom, "#dfe3e7", 1));
            String anchor = i == 0 ? "start" : i == TICKS ? "end" : "middle";
            String words = (ReadableNumbers.number(value) + " " + unit).strip();
            svg.append(text(i == 0 ? LEFT : x(value), bottom + 17.0, anchor, words));
        }
        for (int i = 0; i < bars.size(); i++) {
            draw(bars.get(i), ROW * i, svg);
        }
        return svg + "</svg></div>\n";
    }

    private void draw(Bar bar, double top, StringBuilder svg) {
        double middle = top + 29.0;
        svg.append(format(
                "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"16\" fill=\"%s\" fill-opacity=\"0.55\"/>%n",
                LEFT, middle - 8.0, x(bar.value()) - LEFT, bar.colour()));
        if (bar.high() > bar.low()) {
            svg.append(line(x(bar.low()), middle, x(bar.high()), middle, "#20262e", 2));
            svg.append(line(x(bar.low()), middle - 6.0, x(bar.low()), middle + 6.0, "#20262e", 2));
            svg.append(line(x(bar.high()), middle - 6.0, x(bar.high()), middle + 6.0, "#20262e", 2));
        }
        svg.append(text(LEFT, top + 15.0, "start", bar.words()));
    }

    /** Estimates may lie slightly outside of the scale. */
    private double x(double value) {
        return LEFT + LENGTH * Math.max(0.0, Math.min(1.0, value / most));
    }

    private static String line(double x1, double y1, double x2, double y2, String colour, int width) {
        return format(
                "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" stroke-width=\"%d\"/>%n",
                x1, y1, x2, y2, colour, width);
    }

    private static String text(double x, double y, String anchor, String words) {
        return format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">%s</text>%n", x, y, anchor, Html.text(words));
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
