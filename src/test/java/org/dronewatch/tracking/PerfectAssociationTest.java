package org.dronewatch.tracking;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.LookId;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.alarm.FalseAlarmSource;
import org.junit.jupiter.api.Test;

class PerfectAssociationTest {
    private static final Optional<Sighting> SIGHTING =
            Optional.of(new Sighting(new Position(0, 0, 0), new Direction(1.0, 0.1), OptionalDouble.of(123.0)));

    private static Observation look(String sensor, String drone, double value) {
        return new Observation(new LookId(sensor, "radar", 4, 8.0), drone, 321.0, new Reading(value, 12.0, "dB"))
                .withSighting(SIGHTING);
    }

    private static Observation nothing(String sensor) {
        return Observation.ofNothing(new LookId(sensor, "radar", 4, 8.0), new Reading(13.0, 12.0, "dB"), SIGHTING);
    }

    @Test
    void allLooksAtOneDroneAreOneContact() {
        PerfectAssociation association = new PerfectAssociation();
        List<ContactLook> first =
                association.associate(List.of(look("a", "x", 20), look("a", "y", 1), look("b", "x", 3)));
        List<ContactLook> second = association.associate(List.of(look("b", "y", 20), look("a", "x", 20)));

        assertThat(first).extracting(ContactLook::contact).containsExactly(1, 2, 1);
        assertThat(first).extracting(ContactLook::isDetected).containsExactly(true, false, false);
        assertThat(second).extracting(ContactLook::contact).containsExactly(2, 1);
        assertThat(association.contactOf("y")).hasValue(2);
        assertThat(association.droneOf(1)).contains("x");
        assertThat(association.contactOf("never seen")).isEmpty();
    }

    @Test
    void aFalseMeasurementIsAContactByItself() {
        PerfectAssociation association = new PerfectAssociation();
        List<ContactLook> looks =
                association.associate(List.of(nothing("a"), look("a", "x", 20), nothing("a"), nothing("b")));

        assertThat(looks).extracting(ContactLook::contact).containsExactly(1, 2, 3, 4);
        assertThat(looks).allMatch(ContactLook::isDetected);
        assertThat(association.droneOf(1)).isEmpty();
        assertThat(association.droneOf(2)).contains("x");
    }

    private static Observation inCell(String sensor, double cell) {
        return nothing(sensor).withFigures(Map.of(FalseAlarmSource.CELL, cell));
    }

    /** Patience of three looks: hit, miss, miss, hit; then three misses, and the next one is another contact. */
    @Test
    void falseMeasurementsInOnePlaceAreOneContactForAWhile() {
        PerfectAssociation association = new PerfectAssociation(3);
        List<String> looked = List.of("a");
        List<ContactLook> all = new ArrayList<>();
        boolean[] hits = {true, false, false, true, false, false, false, true};
        for (int i = 0; i < hits.length; i++) {
            List<Observation> seen = hits[i] ? List.of(inCell("a", 5)) : List.of();
            all.addAll(association.associate(seen, looked, i));
            assertThat(association.ended()).isEqualTo(i == 6 ? List.of(1) : List.of());
        }
        assertThat(all).extracting(ContactLook::contact).containsExactly(1, 1, 1, 1, 1, 1, 2);
        assertThat(all)
                .extracting(ContactLook::isDetected)
                .containsExactly(true, false, false, true, false, false, true);
    }

    @Test
    void cellsAndSensorsAreKeptApart() {
        PerfectAssociation association = new PerfectAssociation(5);
        List<ContactLook> first = association.associate(
                List.of(inCell("a", 1), inCell("a", 2), inCell("b", 1), inCell("a", 1), look("a", "x", 20)),
                List.of("a", "b"),
                8.0);
        assertThat(first).extracting(ContactLook::contact).containsExactly(1, 2, 3, 4);
        assertThat(first.get(0).measurements()).hasSize(2);
        // Only one of the sensors looks: the other's contacts wait.
        List<ContactLook> second = association.associate(List.of(inCell("b", 1)), List.of("b"), 9.0);
        assertThat(second).extracting(ContactLook::contact).containsExactly(3);
        assertThat(association.associate(List.of(), List.of("a"), 10.0))
                .extracting(ContactLook::contact)
                .containsExactly(1, 2);
    }

    @Test
    void withoutAPlaceItEndsAtOnce() {
        PerfectAssociation association = new PerfectAssociation(5);
        association.associate(List.of(nothing("a"), nothing("a")), List.of("a"), 8.0);
        assertThat(association.ended()).containsExactly(1, 2);
        assertThat(association.associate(List.of(), List.of("a"), 9.0)).isEmpty();
        assertThat(association.ended()).isEmpty();
    }

    @Test
    void severalMeasurementsOfOneDroneAreOneLook() {
        List<ContactLook> looks = new PerfectAssociation()
                .associate(List.of(look("a", "x", 2), look("a", "y", 2), look("a", "x", 20), look("a", "x", 21)));

        assertThat(looks).hasSize(2);
        assertThat(looks.get(0).measurements()).hasSize(3);
        assertThat(looks.get(0).isDetected()).isTrue();
        assertThat(looks.get(1).isDetected()).isFalse();
    }

    /** A drone detected, missed and detected again, and false alarms in one cell with equal measurements. */
    @Test
    void aLookAtAFalseContactCannotBeToldFromALookAtADrone() {
        PerfectAssociation ofDrone = new PerfectAssociation(3);
        PerfectAssociation ofNothing = new PerfectAssociation(3);
        boolean[] hits = {true, false, true, true, false, false, true};
        for (int i = 0; i < hits.length; i++) {
            Observation missed = new Observation(new LookId("a", "radar", i, i), "x", 9.0, new Reading(1, 12, "dB"))
                    .withFigures(Map.of(Observation.PROBABILITY, 0.4));
            Observation hit = new Observation(new LookId("a", "radar", i, i), "x", 9.0, new Reading(20, 12, "dB"))
                    .withFigures(Map.of(Observation.PROBABILITY, 0.6))
                    .withSighting(SIGHTING);
            Observation alarm = Observation.ofNothing(hit.look(), hit.reading(), SIGHTING)
                    .withFigures(Map.of(FalseAlarmSource.CELL, 5.0));
            assertThat(ofNothing.associate(hits[i] ? List.of(alarm) : List.of(), List.of("a"), i))
                    .isEqualTo(ofDrone.associate(List.of(hits[i] ? hit : missed), List.of("a"), i))
                    .hasSize(1);
        }
    }

    /** How likely a look was is for scoring, of looks that detected nothing, too. */
    @Test
    void theAssessmentOfALookIsKeptForScoring() {
        PerfectAssociation association = new PerfectAssociation();
        association.associate(List.of(
                look("a", "x", 1).withFigures(Map.of(Observation.PROBABILITY, 0.4)),
                look("a", "x", 1).withFigures(Map.of(Observation.PROBABILITY, 0.3)),
                look("b", "x", 20),
                nothing("b")));
        assertThat(association.assessed())
                .containsExactly(
                        new AssessedLook(1, "a", 8.0, 0.4),
                        new AssessedLook(1, "b", 8.0, 1.0),
                        new AssessedLook(2, "b", 8.0, 1.0));
        association.associate(List.of());
        assertThat(association.assessed()).isEmpty();
    }

    /** Neither the drone's name nor its distance, nor anything that holds them, hangs on a look at a contact. */
    @Test
    void noTruthCanBeReachedFromALook() throws ReflectiveOperationException {
        List<ContactLook> looks =
                new PerfectAssociation().associate(List.of(look("a", "secret", 20), look("b", "secret", 1)));
        List<Object> reached = new ArrayList<>();
        for (ContactLook look : looks) {
            walk(look, reached);
        }
        assertThat(reached).contains("a", 123.0).doesNotContain("secret", 321.0);
        assertThat(reached).noneMatch(Observation.class::isInstance);
    }

    private static void walk(Object value, List<Object> reached) throws ReflectiveOperationException {
        reached.add(value);
        if (value instanceof Record record) {
            for (RecordComponent component : record.getClass().getRecordComponents()) {
                walk(component.getAccessor().invoke(record), reached);
            }
        } else if (value instanceof Collection<?> many) {
            for (Object one : many) {
                walk(one, reached);
            }
        } else if (value instanceof Optional<?> one && one.isPresent()) {
            walk(one.get(), reached);
        } else if (value instanceof OptionalDouble number && number.isPresent()) {
            walk(number.getAsDouble(), reached);
        } else if (value instanceof Map<?, ?> map) {
            walk(map.values(), reached);
        }
    }
}
