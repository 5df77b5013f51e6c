package org.dronewatch.tracking;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.dronewatch.sensor.Measurement;
import org.dronewatch.sensor.Observation;

/**
 * Knows which measurements belong together, because it reads the truth: all looks at one drone are one contact, each
 * false measurement is a contact by itself. It takes the place of a tracker that does not exist yet, and bounds the
 * performance that one could achieve. Contacts are numbered from 1 on in the order in which they appear; the numbers
 * say nothing about drones. One per run.
 */
public final class PerfectAssociation {
    private final Map<String, Integer> contacts = new HashMap<>();
    private final Map<Integer, String> drones = new HashMap<>();
    private int last;

    /**
     * Sorts what the sensors observed at one time.
     *
     * @return each sensor's look at each contact, in the order of the observations
     */
    public List<ContactLook> associate(List<Observation> observations) {
        Map<List<Object>, List<Observation>> looks = new LinkedHashMap<>();
        for (Observation observation : observations) {
            List<Object> key = List.of(observation.sensor(), contact(observation));
            looks.computeIfAbsent(key, unseen -> new ArrayList<>(1)).add(observation);
        }
        List<ContactLook> result = new ArrayList<>(looks.size());
        looks.forEach((key, ofContact) -> result.add(look((Integer) key.get(1), ofContact)));
        return result;
    }

    private int contact(Observation observation) {
        if (observation.isFalse()) {
            return ++last;
        }
        return contacts.computeIfAbsent(observation.drone(), drone -> {
            drones.put(++last, drone);
            return last;
        });
    }

    private static ContactLook look(int contact, List<Observation> observations) {
        Observation first = observations.get(0);
        double probability = observations.stream()
                .mapToDouble(Observation::probability)
                .max()
                .orElse(0.0);
        List<Measurement> measurements = observations.stream()
                .flatMap(one -> one.measurements().stream())
                .toList();
        return new ContactLook(contact, first.sensor(), first.arrival(), probability, measurements);
    }

    /** The contact that a drone is, for scoring; empty when no sensor has looked at it. */
    public OptionalInt contactOf(String drone) {
        Integer contact = contacts.get(drone);
        return contact == null ? OptionalInt.empty() : OptionalInt.of(contact);
    }

    /** The drone that a contact is, for scoring; empty for a false measurement. */
    public Optional<String> droneOf(int contact) {
        return Optional.ofNullable(drones.get(contact));
    }
}
