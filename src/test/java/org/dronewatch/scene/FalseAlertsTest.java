package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.LinkedHashMap;
import java.util.Map;
import org.dronewatch.fusion.AlertRule;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.FalseAlertRate;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.RunResult;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.alarm.FalseAlarms;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarDetection;
import org.dronewatch.sensor.radar.RadarFalseAlarms;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.sensor.rf.RfSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.world.Weather;
import org.junit.jupiter.api.Test;

/** False alarms and false alerts counted in runs without drones, against the closed forms. */
class FalseAlertsTest {
    private static final Weather FAIR = new Weather(0.0, 0.0, 20_000.0, 5_000.0);

    private static final long SEED = 31_337L;
    private static final Position PLACE = new Position(0, 0, 30);
    private static final double DAY = 86_400.0;

    private static final class Nobody extends FloorScene {
        private static final long serialVersionUID = 1L;

        private final transient AlertSettings alert;
        private final transient Map<String, SensorSettings<?>> sensors;
        private final double duration;

        Nobody(AlertSettings alert, Map<String, SensorSettings<?>> sensors, double duration) {
            this.alert = alert;
            this.sensors = sensors;
            this.duration = duration;
        }

        @Override
        protected void build() {
            loadFloor();
            sensors.forEach(this::add);
            setAlert(alert);
            setRun(RunSettings.DEFAULT.withDuration(duration));
        }
    }

    private RunResult run(AlertSettings alert, Map<String, SensorSettings<?>> sensors, double duration) {
        System.out.println("seed " + SEED);
        return new SceneRunner(new Nobody(alert, sensors, duration))
                .seed(SEED)
                .threads(1)
                .run()
                .runs()
                .get(0);
    }

    private static AlertSettings gated(double degrees) {
        return AlertSettings.DEFAULT.withRule(AlertRule.SeveralSensors.of(2).withGate(Math.toRadians(degrees)));
    }

    private static AlertSettings confirmed(int hits, int looks) {
        return AlertSettings.DEFAULT.withConfirmation(hits, looks);
    }

    /** In 200 cells, each with a chance of about 0.02 a look. */
    private static RadarSettings radar(double rate, double perScan) {
        return RadarSettings.at(PLACE, LinkBudget.DataSheet.of(1000, 0.01))
                .withRate(rate)
                .withDetection(new RadarDetection.Chance(perScan / 20_000, 1))
                .withFalseAlarms(RadarFalseAlarms.DEFAULT.withCells(20_000).withGate(100));
    }

    private static RfSettings radio(FalseAlarms often) {
        return RfSettings.at(PLACE).withFalseAlarms(often);
    }

    private void assertAgrees(AlertSettings alert, Map<String, SensorSettings<?>> sensors, double duration) {
        RunResult run = run(alert, sensors, duration);
        double expected = rate(alert, sensors).perDay() * duration / DAY;
        long counted = run.falseAlarms().alertCount();
        System.out.printf("%d false alerts, expected %.1f%n", counted, expected);
        assertThat(expected).as("enough to tell").isGreaterThan(100.0);
        assertThat((double) counted).isCloseTo(expected, within(3.5 * Math.sqrt(expected)));
    }

    @Test
    void asManyFalseAlarmsAsStated() {
        RunResult run = run(AlertSettings.DEFAULT, Map.of("radar", radar(100, 4)), 20);
        double expected = 4 * 100 * 20;
        assertThat((double) run.falseAlarms().counted().get("radar"))
                .isCloseTo(expected, within(4.0 * Math.sqrt(expected)));
        assertThat(run.alerts()).isEmpty();
        assertThat(run.events()).isEmpty();
    }

    @Test
    void everyFalseAlarmIsAnAlertWithoutConfirmation() {
        assertAgrees(AlertSettings.DEFAULT, Map.of("radar", radar(10, 0.5)), 100);
    }

    /** 6 p^3 (1-p)^3 a look in each of 200 cells, p = 0.02. */
    @Test
    void threeOfFiveInTheSamePlace() {
        assertAgrees(confirmed(3, 5), Map.of("radar", radar(1000, 4)), 20);
    }

    @Test
    void twoOfThreeOfTwoRadars() {
        Map<String, SensorSettings<?>> two = new LinkedHashMap<>();
        two.put("one", radar(400, 1));
        two.put("other", radar(250, 1.3));
        assertAgrees(confirmed(2, 3), two, 40);
    }

    /** A bird that lasts for four looks confirms itself. */
    @Test
    void whatLastsIsConfirmed() {
        RfSettings radio = radio(new FalseAlarms(60, 7, 4));
        assertAgrees(confirmed(3, 5), Map.of("radio", radio), 20_000);
    }

    /** What lasts for two looks of three cannot: the closed form is an upper bound. */
    @Test
    void whatLastsTooShortlyNeedsAnother() {
        Map<String, SensorSettings<?>> sensors = Map.of("radio", radio(new FalseAlarms(100, 1, 2)));
        FalseAlertRate bound = rate(confirmed(3, 5), sensors);
        RunResult run = run(confirmed(3, 5), sensors, 60_000);
        double most = bound.perDay() * 60_000 / DAY;
        long counted = run.falseAlarms().alertCount();
        System.out.printf("%d false alerts, at most %.1f%n", counted, most);
        assertThat(bound.isUpperBound()).isTrue();
        assertThat(counted).isLessThan((int) (most + 3.5 * Math.sqrt(most))).isGreaterThan((int) (0.5 * most));
    }

    /** A worse sensor must not look better: where false alarms merge, the rate stays at its greatest value. */
    @Test
    void moreFalseAlarmsNeverCostFewerAlerts() {
        for (int[] rule : new int[][] {{1, 1}, {2, 3}, {3, 5}}) {
            for (double lasting : new double[] {0.0, 1.5, 4.0, 10.0}) {
                double before = 0.0;
                for (double perHour = 1.0; perHour <= 3e5; perHour *= 3.0) {
                    FalseAlertRate rate = rate(
                            confirmed(rule[0], rule[1]), Map.of("radio", radio(new FalseAlarms(perHour, 1, lasting))));
                    assertThat(rate.perDay())
                            .as("%d of %d, %s s, %s an hour", rule[0], rule[1], lasting, perHour)
                            .isGreaterThanOrEqualTo(before);
                    before = rate.perDay();
                }
            }
        }
        FalseAlertRate merged = rate(confirmed(3, 5), Map.of("radio", radio(new FalseAlarms(36_000, 1, 10))));
        assertThat(merged.merging()).containsExactly("radio");
        assertThat(merged.inWords()).isEqualTo("2192 per day; radio raises false alarms most of the time");
        assertThat(rate(confirmed(3, 5), Map.of("radio", radio(new FalseAlarms(100, 1, 10))))
                        .merging())
                .isEmpty();
    }

    /** Two sensors without bearings, 5 seconds: 2 a b T, and those in the same second. */
    @Test
    void twoThatMeasureNoBearing() {
        Map<String, SensorSettings<?>> two = new LinkedHashMap<>();
        two.put("one", radio(new FalseAlarms(36, 1000, 0)));
        two.put("other", radio(new FalseAlarms(50, 1000, 0)));
        assertAgrees(AlertSettings.DEFAULT.withRule(AlertRule.SeveralSensors.of(2)), two, 80_000);
    }

    @Test
    void twoAtTheSameTime() {
        Map<String, SensorSettings<?>> two = new LinkedHashMap<>();
        two.put("one", radio(new FalseAlarms(180, 1000, 0)));
        two.put("other", radio(new FalseAlarms(180, 1000, 0)));
        assertAgrees(AlertSettings.DEFAULT.withRule(new AlertRule.SeveralSensors(2, 0.0)), two, 80_000);
    }

    /** Radars all round agree within 40 degrees on either side two times of nine, within 10 one time of 18. */
    @Test
    void twoRadarsAgreeInBearing() {
        Map<String, SensorSettings<?>> two = new LinkedHashMap<>();
        two.put("one", radar(0.2, 0.07));
        two.put("other", radar(0.25, 0.06));
        assertAgrees(gated(40), two, 300_000);
        double nearly = rate(gated(10), two).perDay();
        assertThat(rate(gated(20), two).perDay()).isCloseTo(2.0 * nearly, withinPercentage(2));
        assertThat(rate(gated(180), two).perDay()).isBetween(15.0 * nearly, 18.0 * nearly);
    }

    /** A radar all round and a camera of 60 degrees. */
    @Test
    void aRadarAndACamera() {
        Map<String, SensorSettings<?>> two = new LinkedHashMap<>();
        two.put("radar", radar(0.2, 0.05));
        two.put(
                "camera",
                CameraSettings.at(PLACE)
                        .withHorizontalFov(Math.toRadians(60))
                        .withRate(0.2)
                        .withFalseAlarms(new FalseAlarms(50, 5000, 10)));
        assertAgrees(gated(40), two, 300_000);
    }

    @Test
    void threeSensors() {
        Map<String, SensorSettings<?>> three = new LinkedHashMap<>();
        three.put("radio", radio(new FalseAlarms(100, 1000, 0)));
        three.put("array", radio(new FalseAlarms(120, 1000, 0)));
        three.put("radar", radar(1, 0.05));
        assertAgrees(AlertSettings.DEFAULT.withRule(AlertRule.SeveralSensors.of(3)), three, 60_000);
    }

    /** A stated probability does not make one alarm out of two: each is an alert. */
    @Test
    void jointProbabilities() {
        assertAgrees(
                AlertSettings.DEFAULT.withRule(AlertRule.UnionOfProbabilities.of(0.99)),
                Map.of("radar", radar(10, 0.5)),
                100);
    }

    /** What a rule for several sensors has to remember is bounded; the same rates are fine for a shorter time. */
    @Test
    void aRuleThatWouldRememberTooManyIsRefused() {
        Map<String, SensorSettings<?>> two = new LinkedHashMap<>();
        two.put("radar", radar(100, 4));
        two.put("camera", CameraSettings.at(PLACE));
        AlertSettings hour = AlertSettings.DEFAULT.withRule(new AlertRule.SeveralSensors(2, 3600));
        assertThatThrownBy(() -> run(hour, two, 1))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(
                        "alert.rule.within 3600.0 s with 388 confirmed false alarms a second gives 1.4e+06 that"
                                + " count at the same time; there must be at most 200000");
        run(hour.withConfirmation(3, 5), Map.of("radar", radar(1, 4), "camera", CameraSettings.at(PLACE)), 1);
        run(AlertSettings.DEFAULT.withRule(new AlertRule.SeveralSensors(2, 60)), two, 1);
    }

    private static FalseAlertRate rate(AlertSettings alert, Map<String, SensorSettings<?>> sensors) {
        return FalseAlertRate.of(alert, sensors, FAIR);
    }
}
