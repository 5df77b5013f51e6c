package org.dronewatch.fusion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.LookId;
import org.dronewatch.sensor.Measurement;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Reading;
import org.dronewatch.tracking.ContactLook;
import org.dronewatch.tracking.PerfectAssociation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AlertLogTest {

    private static final int CONTACT = 7;

    private static ContactLook look(String sensor, double time, double value) {
        Measurement measured = new Measurement(
                new LookId(sensor, "camera", 0, time), new Reading(value, 12.0, "px"), Optional.empty());
        return new ContactLook(CONTACT, sensor, time, measured.isDetected() ? List.of(measured) : List.of());
    }

    /** A log in a run in which all contacts are false, unless several sensors share them. */
    private static AlertLog log(AlertSettings settings) {
        return new AlertLog(settings, new PerfectAssociation()::matcher);
    }

    @Test
    void theFirstDetectionOfAnySensorIsAnAlertUnlessTheSettingsSayOtherwise() {
        AlertLog log = log(AlertSettings.DEFAULT);
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
        AlertLog log = log(settings);
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
        AlertLog log = log(AlertSettings.DEFAULT.withConfirmation(2, 2));
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
            AlertLog log = log(AlertSettings.DEFAULT.withConfirmation(3, 4));
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
        AlertLog late = log(two);
        late.add(List.of(look("a", 0, 20), look("b", 0, 0)));
        late.add(List.of(look("a", 5.5, 0), look("b", 5.5, 20)));
        assertThat(late.alert(CONTACT)).isEmpty();

        AlertLog early = log(two);
        early.add(List.of(look("a", 0, 20), look("b", 0, 0)));
        early.add(List.of(look("a", 4.5, 0), look("b", 4.5, 20)));
        assertThat(early.alert(CONTACT)).contains(new Alert(CONTACT, 4.5, List.of("a", "b")));
    }

    /** A rule that forecasts alerts decides nothing. */
    @Test
    void noAlertIsRaisedByAForecast() {
        AlertLog log = log(AlertSettings.DEFAULT.withRule(AlertRule.UnionOfProbabilities.of(0.1)));
        assertThat(log.add(List.of(look("a", 0, 20)))).isEmpty();
        assertThat(log.alert(CONTACT)).isEmpty();
        assertThat(log.size()).isZero();
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

    private static ContactLook single(int contact, String sensor, double time, double bearing) {
        Sighting seen = new Sighting(
                new Position(0, 0, 0), new Direction(Math.toRadians(bearing), 0.1), OptionalDouble.empty());
        Measurement measured =
                new Measurement(new LookId(sensor, "camera", 0, time), new Reading(20, 12.0, "px"), Optional.of(seen));
        return new ContactLook(contact, sensor, time, List.of(measured));
    }

    private static ContactLook withoutABearing(int contact, String sensor, double time) {
        ContactLook seen = look(sensor, time, 50);
        return new ContactLook(contact, sensor, time, seen.measurements());
    }

    /** Across north, too: 355 and 3 degrees are 8 degrees apart. */
    @Test
    void contactsOfTwoSensorsCountTogetherIfTheyAgree() {
        AlertLog log = log(two(10));
        assertThat(log.add(List.of(single(1, "a", 0, 355)))).isEmpty();
        assertThat(log.add(List.of(single(2, "a", 1, 356)))).isEmpty();
        assertThat(log.add(List.of(single(3, "b", 2, 20)))).isEmpty();
        assertThat(log.add(List.of(single(4, "b", 3, 3)))).containsExactly(new Alert(4, 3.0, List.of("a", "b")));
        // The nearest of the first sensor has been used up, its other one not.
        assertThat(log.alert(2)).isPresent();
        assertThat(log.add(List.of(single(5, "b", 4, 1)))).hasSize(1);
        assertThat(log.alert(1)).contains(new Alert(5, 4.0, List.of("a", "b")));
        assertThat(log.add(List.of(single(6, "b", 5, 1)))).isEmpty();
    }

    private static AlertSettings two(double gateDegrees) {
        return AlertSettings.DEFAULT.withRule(
                new AlertRule.SeveralSensors(2, 5.0).withGate(Math.toRadians(gateDegrees)));
    }

    @Test
    void falseContactsDoNotConfirmADrone() {
        PerfectAssociation association = new PerfectAssociation();
        Observation drone =
                new Observation(new LookId("a", "camera", 0, 0), "intruder", 100.0, new Reading(50, 12.0, "px"));
        int intruder = association.associate(List.of(drone)).get(0).contact();
        AlertLog log = new AlertLog(two(10), association::matcher);
        assertThat(log.add(List.of(single(intruder, "a", 0, 7), single(8, "b", 0, 7))))
                .isEmpty();
        assertThat(log.add(List.of(single(intruder, "a", 1, 7), single(9, "a", 1, 7))))
                .extracting(Alert::contact)
                .containsExactly(9);
        assertThat(log.alert(intruder)).isEmpty();
    }

    @Test
    void contactsWithoutABearingAgreeWithAllAndLateOnesWithNone() {
        AlertLog log = log(two(10));
        log.add(List.of(withoutABearing(CONTACT, "radio", 0)));
        assertThat(log.add(List.of(single(1, "a", 5, 123))))
                .extracting(Alert::time)
                .containsExactly(5.0);
        AlertLog late = log(two(10));
        late.add(List.of(withoutABearing(CONTACT, "radio", 0)));
        assertThat(late.add(List.of(single(1, "a", 5.1, 123)))).isEmpty();
    }

    /** A contact that nothing confirms at present does not bring together two others, which do not agree. */
    @Test
    void twoOnEitherSideOfAThirdDoNotAgree() {
        AlertLog log = log(two(10).withConfirmation(2, 2));
        for (int time = 0; time < 3; time++) {
            assertThat(log.add(List.of(
                            single(1, "a", time, 92),
                            single(2, "b", time, 108),
                            time == 1 ? missed(3, "c", time) : single(3, "c", time, 100))))
                    .isEmpty();
        }
        assertThat(log.add(List.of(single(3, "c", 3, 100))))
                .extracting(Alert::sensors)
                .containsExactly(List.of("a", "b", "c"));
    }

    private static ContactLook missed(int contact, String sensor, double time) {
        return new ContactLook(contact, sensor, time, List.of());
    }

    @Test
    void whatHasEndedIsForgottenButCountsWithOthersForAWhile() {
        AlertLog log = log(two(10));
        log.add(List.of(single(1, "a", 0, 90)));
        log.forget(List.of(1, 99));
        assertThat(log.add(List.of(single(2, "b", 4, 91)))).containsExactly(new Alert(2, 4.0, List.of("a", "b")));
        log.forget(List.of(2));
        assertThat(log.alert(1)).isEmpty();
        assertThat(log.alert(2)).isEmpty();
        assertThat(log.size()).isZero();
    }

    /** The rule as it reads: of all that were confirmed within the time, the nearest of each other sensor. */
    private static final class AllPairs {
        private record Seen(int contact, String sensor, double time, double bearing) {}

        private final List<Seen> recent = new ArrayList<>();

        private static double between(double one, double other) {
            double apart = Math.abs(one - other) % 360.0;
            return Math.min(apart, 360.0 - apart);
        }

        List<Integer> add(Seen now, double gate) {
            recent.removeIf(old -> old.time < now.time - 5.0);
            recent.add(now);
            Seen best = null;
            for (Seen old : recent) {
                double apart = between(old.bearing, now.bearing);
                boolean agrees = !old.sensor.equals(now.sensor) && apart <= gate;
                if (agrees && (best == null || apart < between(best.bearing, now.bearing))) {
                    best = old;
                }
            }
            if (best == null) {
                return List.of();
            }
            recent.remove(best);
            recent.remove(now);
            return List.of(best.contact, now.contact);
        }
    }

    @Thorough
    @ParameterizedTest
    @ValueSource(doubles = {0.003, 1, 10, 90, 180})
    void contactsAgreeAsIfEachWereComparedWithAll(double gate) {
        long seed = 20_261_125;
        System.out.println("seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        AllPairs reference = new AllPairs();
        AlertLog log = log(two(gate));
        int alerts = 0;
        double time = 0.0;
        for (int contact = 1; contact <= 20_000; contact++) {
            time += random.nextDouble() * 0.02;
            // Many more of one sensor than of the other, so that they wait; and the seam at south.
            String sensor = random.nextInt(5) == 0 ? "a" : "b";
            double bearing = random.nextInt(3) == 0 ? 178.0 + 4.0 * random.nextDouble() : 360.0 * random.nextDouble();
            List<Alert> raised = log.add(List.of(single(contact, sensor, time, bearing)));
            List<Integer> expected = reference.add(new AllPairs.Seen(contact, sensor, time, bearing), gate);
            assertThat(raised).as("contact %d", contact).hasSize(expected.isEmpty() ? 0 : 1);
            for (int used : expected) {
                assertThat(log.alert(used)).contains(raised.get(0));
                alerts++;
            }
        }
        assertThat(alerts).isGreaterThan(100);
    }

    /**
     * 300,000 false contacts, of which up to a hundred thousand count at a time: compared with each other this would
     * take some 2e10 comparisons; in the long form, a million and 1e11. Nothing is remembered longer than it counts.
     */
    @Thorough
    @Test
    void manyContactsTakeSeconds() {
        int waiting = 100_000;
        AlertLog log = log(two(0.001));
        SplittableRandom random = new SplittableRandom(9);
        int most = 0;
        long alerts = 0;
        for (int contact = 1; contact <= LongForm.count(300_000, 1_000_000); contact++) {
            // One sensor sees nothing but the west, the other the east: all wait in vain, but for a few at the seam.
            boolean isWest = contact % 2 == 0;
            double bearing = (isWest ? 180.0 : 0.0) + 180.0 * random.nextDouble();
            double time = contact * 5.0 / waiting;
            alerts += log.add(List.of(single(contact, isWest ? "a" : "b", time, bearing)))
                    .size();
            log.forget(List.of(contact));
            most = Math.max(most, log.size());
        }
        assertThat(most).isBetween(waiting - 1000, waiting + 2);
        assertThat(alerts).isLessThan(100);
    }

    /** A sensor alone, whose contacts nobody asks for, does not fill the memory either. */
    @Test
    void contactsOfOneSensorAloneAreForgotten() {
        AlertLog log = log(two(10));
        for (int contact = 1; contact <= 10_000; contact++) {
            log.add(List.of(single(contact, "a", contact * 0.1, 7)));
            log.forget(List.of(contact));
        }
        assertThat(log.size()).isBetween(40, 60);
    }
}
