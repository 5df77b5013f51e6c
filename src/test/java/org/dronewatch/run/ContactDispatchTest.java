package org.dronewatch.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.dronewatch.fusion.AlertLog;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.Positioner;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.LookId;
import org.dronewatch.sensor.Measurement;
import org.dronewatch.sensor.Reading;
import org.dronewatch.tracking.ContactLook;
import org.dronewatch.tracking.PerfectAssociation;
import org.junit.jupiter.api.Test;

/** What positioners are told of several contacts that appear at once. */
class ContactDispatchTest {
    private static final Position RADAR = new Position(0, 0, 10);
    private static final Position MAST = new Position(5, 0, 10);

    private final long seed = System.nanoTime();
    private final SplittableRandom random = new SplittableRandom(seed);

    private ContactLook look(int contact, String sensor) {
        Direction direction = new Direction(random.nextDouble(-3.0, 3.0), random.nextDouble(0.0, 1.0));
        Sighting sighting = new Sighting(RADAR, direction, OptionalDouble.of(500.0));
        Measurement measured =
                new Measurement(new LookId(sensor, "radar", 0, 1.0), new Reading(20, 13, "dB"), Optional.of(sighting));
        return new ContactLook(contact, sensor, 1.0, List.of(measured));
    }

    private static int followed(List<ContactLook> looks) {
        ContactDispatch dispatch =
                new ContactDispatch(new AlertLog(AlertSettings.DEFAULT, new PerfectAssociation()::matcher));
        PositionerSettings settings = PositionerSettings.DEFAULT.withCues("north", "south");
        dispatch.add("camera", new Positioner(settings, MAST, new Direction(0, 0), 1.0, 0.04));
        dispatch.pass(looks);
        return dispatch.moveTo("camera", 2.0)
                .map(Pointing::contact)
                .orElseThrow()
                .orElseThrow();
    }

    /** Drones come first in the list: if the first were followed, false alarms would never divert a camera. */
    @Test
    void whichContactIsFollowedDoesNotDependOnTheirOrderOrNumbers() {
        int first = 0;
        for (int i = 0; i < 1000; i++) {
            ContactLook one = look(1, "north");
            ContactLook other = look(2, "south");
            int contact = followed(List.of(one, other));
            assertThat(followed(List.of(other, one))).as("seed %d", seed).isEqualTo(contact);
            first += contact == 1 ? 1 : 0;
        }
        // Binomial: the standard deviation is 16.
        assertThat(first).as("of 1000 with contact 1 in front, seed %d", seed).isBetween(420, 580);
    }
}
