package org.dronewatch.docs;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.Confirmation;
import org.dronewatch.fusion.FalseAlertRate;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.alarm.FalseAlarms;
import org.dronewatch.sensor.rf.RfSettings;
import org.dronewatch.world.Weather;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.style.Styler.LegendPosition;

/**
 * What four confirmations cost and gain: false alerts per day by the rate of false alarms, and the time to the alert.
 */
final class FalseAlertsPlot {
    private static final List<Confirmation> RULES =
            List.of(new Confirmation(1, 1), new Confirmation(2, 3), new Confirmation(3, 5), new Confirmation(5, 8));
    private static final Color[] COLOURS = {
        new Color(0xc2410c), new Color(0xb58900), new Color(0x1f5fbf), new Color(0x2a9d5c)
    };
    private static final int CELLS = 1000;
    private static final double LOOK_PROBABILITY = 0.7;
    private static final int POINTS = 121;
    private static final int MOST_LOOKS = 20;

    private FalseAlertsPlot() {}

    static BufferedImage draw() {
        XYChart price = DocChart.of(
                DocChart.HALF_WIDTH, "1000 cells, 1 look per second", "false alarms per hour", "false alerts per day");
        price.getStyler().setXAxisLogarithmic(true).setYAxisLogarithmic(true);
        price.getStyler().setYAxisMin(1e-3).setYAxisMax(1e6).setLegendPosition(LegendPosition.InsideNW);
        XYChart time = DocChart.of(
                DocChart.HALF_WIDTH,
                "A drone that each look detects with probability 0.7",
                "looks",
                "probability of an alert so far");
        time.getStyler().setYAxisMin(0.0).setYAxisMax(1.0).setLegendPosition(LegendPosition.InsideSE);
        double[] hourly = new double[POINTS];
        for (int i = 0; i < POINTS; i++) {
            hourly[i] = Math.pow(10.0, 4.0 * i / (POINTS - 1.0));
        }
        double[] looks = new double[MOST_LOOKS];
        for (int i = 0; i < MOST_LOOKS; i++) {
            looks[i] = i + 1;
        }
        for (int i = 0; i < RULES.size(); i++) {
            Confirmation rule = RULES.get(i);
            String name = rule.hits() + " of " + rule.looks();
            // Below the lowest line there is nothing to see, and the logarithm of nothing is no number.
            DocChart.add(price, name, hourly, of(hourly, rate -> Math.max(1e-9, perDay(rule, rate))), COLOURS[i]);
            DocChart.add(time, name, looks, alerted(rule), COLOURS[i]);
        }
        return DocChart.beside(price, time);
    }

    private static double perDay(Confirmation rule, double perHour) {
        RfSettings sensor = RfSettings.at(new Position(0, 0, 0)).withFalseAlarms(new FalseAlarms(perHour, CELLS, 0));
        AlertSettings alert = AlertSettings.DEFAULT.withConfirmation(rule.hits(), rule.looks());
        return FalseAlertRate.of(alert, Map.of("sensor", sensor), new Weather(0.0, 0.0, 20_000.0, 5_000.0))
                .perDay();
    }

    /** Look by look over all combinations of the latest looks, of which none before the first has detected anything. */
    private static double[] alerted(Confirmation rule) {
        double[] states = new double[1 << rule.looks()];
        states[0] = 1.0;
        double[] alerted = new double[MOST_LOOKS];
        double sum = 0.0;
        for (int look = 0; look < MOST_LOOKS; look++) {
            double[] next = new double[states.length];
            for (int state = 0; state < states.length; state++) {
                for (int hit = 0; hit <= 1; hit++) {
                    int after = (state << 1 | hit) & states.length - 1;
                    double chance = states[state] * (hit == 1 ? LOOK_PROBABILITY : 1.0 - LOOK_PROBABILITY);
                    if (Integer.bitCount(after) >= rule.hits()) {
                        sum += chance;
                    } else {
                        next[after] += chance;
                    }
                }
            }
            states = next;
            alerted[look] = sum;
        }
        return alerted;
    }

    private static double[] of(double[] x, DoubleUnaryOperator function) {
        double[] y = new double[x.length];
        for (int i = 0; i < x.length; i++) {
            y[i] = function.applyAsDouble(x[i]);
        }
        return y;
    }
}
