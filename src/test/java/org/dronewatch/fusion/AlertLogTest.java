package org.dronewatch.fusion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.LookId;
import org.dronewatch.sensor.Measurement;
import org.dronewatch.sensor.Reading;
import org.dronewatch.tracking.ContactLook;
import org.junit.jupiter.api.Test;

class AlertLogTest {

    private static final int CONTACT = 7;

    private static ContactLook look(String sensor, double time, double value) {
        Measurement measured = new Measurement(
                new LookId(sensor, "camera", 0, time), new Reading(value, 12.0, "px"), Optional.empty());
        boolean detected = measured.isDetected();
        return new ContactLook(CONTACT, sensor, time, detected ? 1.0 : 0.0, detected ? List.of(measured) : List.of());
    }

    private static ContactLook likely(String sensor, double time, double probability) {
        return new ContactLook(CONTACT, sensor, time, probability, List.of());
    }

    @Test
    void theFirstDetectionOfAnySensorIsAnAlertUnlessTheSettingsSayOtherwise() {
        AlertLog log = new AlertLog(AlertSettings.DEFAULT);
        log.add(List.of(look("a", 0, 11.9), look("b", 0, 3)));
        assertThat(log.alert(CONTACT)).isEmpty();
        log.add(List.of(look("a", 1, 2), look("b", 1, 12)));
        log.add(List.of(look("a", 2, 50), look("b", 2, 50)));

        assertThat(log.alert(CONTACT)).contains(new Alert(CONTACT, 1.0, List.of("b")));
        assertThat(log.alert(CONTACT + 1)).isEmpty();
    }

    @Test
    void aSensorIsConfirmedByMOfItsLastNLooks() {
        AlertSettings settings = AlertSettings.DEFAULT.withConfirmation(3, 4);
        // hit, miss, hit, miss: two of four. hit: three of the last four would need one more.
        double[] values = {20, 1, 20, 1, 20, 20, 1};
        AlertLog log = new AlertLog(settings);
        List<Optional<Alert>> after = new ArrayList<>();
        for (int i = 0; i < values.length; i++) {
            log.add(List.of(look("a", i, values[i])));
            after.add(log.alert(CONTACT));
        }
        assertThat(after.get(4)).isEmpty();
        assertThat(after.get(5)).contains(new Alert(CONTACT, 5.0, List.of("a")));
    }

    @Test
    void looksThatAreTooOldAreForgotten() {
        AlertLog log = new AlertLog(AlertSettings.DEFAULT.withConfirmation(2, 2));
        double[] values = {20, 1, 20, 1, 20, 1};
        for (int i = 0; i < values.length; i++) {
            log.add(List.of(look("a", i, values[i])));
        }
        assertThat(log.alert(CONTACT)).isEmpty();
    }

    /** Three of four looks at 0.9 each: 4 * 0.9^3 * 0.1 + 0.9^4 = 0.9477. */
    @Test
    void threeOfFourAtNineTenthsSucceedAsTheBinomialSays() {
        long seed = 97;
        System.out.println("seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        int trials = 200_000;
        int alerts = 0;
        for (int trial = 0; trial < trials; trial++) {
            AlertLog log = new AlertLog(AlertSettings.DEFAULT.withConfirmation(3, 4));
            for (int look = 0; look < 4; look++) {
                log.add(List.of(look("a", look, random.nextDouble() < 0.9 ? 12 : 0)));
            }
            alerts += log.alert(CONTACT).isPresent() ? 1 : 0;
        }
        assertThat((double) alerts / trials).isCloseTo(0.9477, within(4 * Math.sqrt(0.9477 * 0.0523 / trials)));
    }

    @Test
    void severalSensorsMustAgreeWithinATime() {
        AlertSettings two = AlertSettings.DEFAULT.withRule(new AlertRule.SeveralSensors(2, 5.0));
        AlertLog late = new AlertLog(two);
        late.add(List.of(look("a", 0, 20), look("b", 0, 0)));
        late.add(List.of(look("a", 5.5, 0), look("b", 5.5, 20)));
        assertThat(late.alert(CONTACT)).isEmpty();

        AlertLog early = new AlertLog(two);
        early.add(List.of(look("a", 0, 20), look("b", 0, 0)));
        early.add(List.of(look("a", 4.5, 0), look("b", 4.5, 20)));
        assertThat(early.alert(CONTACT)).contains(new Alert(CONTACT, 4.5, List.of("a", "b")));
    }

    /** 1 - 0.4 * 0.5 * 0.7 = 0.86. */
    @Test
    void probabilitiesOfIndependentSensorsJoin() {
        List<ContactLook> looks = List.of(likely("a", 0, 0.6), likely("b", 0, 0.5), likely("c", 0, 0.3));
        for (double probability : new double[] {0.8599, 0.86}) {
            AlertLog log = new AlertLog(AlertSettings.DEFAULT.withRule(AlertRule.UnionOfProbabilities.of(probability)));
            log.add(looks);
            assertThat(log.alert(CONTACT).orElseThrow().sensors()).containsExactly("a", "b", "c");
        }
        AlertLog log = new AlertLog(AlertSettings.DEFAULT.withRule(AlertRule.UnionOfProbabilities.of(0.8601)));
        log.add(looks);
        assertThat(log.alert(CONTACT)).isEmpty();
        // A look of long ago does not count.
        log.add(List.of(likely("c", 3, 0.8)));
        assertThat(log.alert(CONTACT)).isEmpty();
    }

    @Test
    void anAlertRestsOnTheLikeliestAlone() {
        AlertLog log = new AlertLog(AlertSettings.DEFAULT.withRule(AlertRule.UnionOfProbabilities.of(0.9)));
        log.add(List.of(likely("faint", 0, 0.01), likely("sure", 0, 0.95), likely("fair", 0, 0.5)));

        assertThat(log.alert(CONTACT).orElseThrow().sensors()).containsExactly("sure");
    }

    @Test
    void aZoneIsReachedWhereTheStraightWayMeetsItsEdge() {
        ProtectedZone zone = new ProtectedZone(new Position(0, 0, 50), 1);

        assertThat(zone.entry(new Position(0, 101, 50), new Position(0, -99, 50))
                        .orElseThrow())
                .isCloseTo(0.5, within(1e-12));
        assertThat(zone.entry(new Position(0, 101, 52), new Position(0, -99, 52)))
                .isEmpty();
        assertThat(zone.entry(new Position(0, 101, 50), new Position(0, 1.5, 50)))
                .isEmpty();
        assertThat(zone.entry(new Position(0, 0.5, 50), new Position(0, 80, 50)))
                .hasValue(0.0);
        assertThat(zone.entry(new Position(0, 9, 50), new Position(0, 80, 50))).isEmpty();
        assertThat(zone.entry(new Position(0, 9, 50), new Position(0, 9, 50))).isEmpty();
    }

    /** 1 km at 10, 20 and 40 m/s. */
    @Test
    void theTimeLeftIsTheWayToTheEdgeOverTheSpeed() {
        ProtectedZone zone = new ProtectedZone(new Position(0, 0, 50), 200);
        Position place = new Position(0, 1200, 50);

        assertThat(zone.timeLeft(place, 10)).isEqualTo(100.0);
        assertThat(zone.timeLeft(place, 20)).isEqualTo(50.0);
        assertThat(zone.timeLeft(place, 40)).isEqualTo(25.0);
        assertThat(zone.timeLeft(new Position(0, 100, 50), 40)).isZero();
    }

    @Test
    void impossibleRulesAreRefused() {
        assertThatThrownBy(() -> new Confirmation(4, 3)).hasMessage("hits 4 must be at most looks 3");
        assertThatThrownBy(() -> AlertRule.UnionOfProbabilities.of(1.2))
                .hasMessage("probability 1.2 must be above 0 and at most 1");
        assertThatThrownBy(() ->
                        AlertSettings.DEFAULT.withConfirmation(2, 3).withRule(AlertRule.UnionOfProbabilities.of(0.9)))
                .hasMessageStartingWith("confirm 2 of 3 looks has no meaning with union-of-probabilities");
    }
}
