package org.dronewatch.tracking;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.dronewatch.sensor.Measurement;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.alarm.FalseAlarmSource;

/**
 * A perfect association of measurements with contacts, which reads the truth: all measurements of one drone form one
 * contact. It takes the place of a tracker, which this library does not have, and performs at least as well as any
 * tracker. False measurements of one sensor in the same cell, given by {@link FalseAlarmSource#CELL}, form one contact,
 * too, which ends after a number of looks without such a measurement (in a run, the number of looks that the
 * confirmation considers); a false measurement without a cell is a separate contact. Contacts are numbered from 1 in
 * the order in which sensors first look at them, whether or not they detect anything: contacts of drones mostly come
 * before false contacts, so nothing may depend on the numbers or on the order of the looks. For use in one run.
 *
 * <p>False contacts of different sensors are matched by time and bearing, as by a tracker ({@link #matcher}); a drone's
 * contact, which all sensors share, matches no other.
 */
public class PerfectAssociation {
    private final Map<String, Integer> contacts = new HashMap<>();
    private final Map<Integer, String> drones = new HashMap<>();
    private final Map<String, LiveAlarms> alarms = new LinkedHashMap<>();
    private final List<Integer> ended = new ArrayList<>();
    private final List<AssessedLook> assessed = new ArrayList<>();
    private final int patience;
    private int last;

    /** An association in which false measurements of different looks never form one contact. */
    public PerfectAssociation() {
        this(1);
    }

    /**
     * An association.
     *
     * @param patience number of looks without a measurement after which a false contact ends, 1 or more
     */
    public PerfectAssociation(int patience) {
        this.patience = patience;
    }

    /**
     * Associates the observations made at one time; a sensor without an observation counts as if it had not looked.
     *
     * @return each sensor's look at each contact, in the order of the observations
     */
    public List<ContactLook> associate(List<Observation> observations) {
        Set<String> sensors = new LinkedHashSet<>();
        observations.forEach(observation -> sensors.add(observation.sensor()));
        double time = observations.isEmpty() ? 0.0 : observations.get(0).arrival();
        return associate(observations, sensors, time);
    }

    /**
     * Associates the observations made at one time.
     *
     * @param looked names of the sensors that looked, whether or not they observed anything
     * @param time time of these looks, seconds since the start of the run
     * @return each sensor's look at each contact, in the order of the observations; then those at false contacts
     *     without a measurement in this look
     */
    public List<ContactLook> associate(List<Observation> observations, Collection<String> looked, double time) {
        ended.clear();
        assessed.clear();
        Map<List<Object>, List<Observation>> looks = new LinkedHashMap<>();
        for (Observation observation : observations) {
            List<Object> key = List.of(observation.sensor(), contact(observation));
            looks.computeIfAbsent(key, unseen -> new ArrayList<>(1)).add(observation);
        }
        List<ContactLook> result = new ArrayList<>(looks.size());
        looks.forEach((key, ofContact) -> result.add(look((Integer) key.get(1), ofContact)));
        for (String sensor : looked) {
            LiveAlarms live = alarms.get(sensor);
            if (live != null) {
                live.endLook(sensor, time, result::add, ended::add);
            }
        }
        return result;
    }

    private int contact(Observation observation) {
        if (observation.isFalse()) {
            Double cell = observation.figures().get(FalseAlarmSource.CELL);
            return cell == null ? single() : ofSensor(observation.sensor()).contactIn(cell, () -> ++last);
        }
        return contacts.computeIfAbsent(observation.drone(), drone -> {
            drones.put(++last, drone);
            return last;
        });
    }

    /** A new contact that will not be seen again. */
    private int single() {
        ended.add(++last);
        return last;
    }

    private LiveAlarms ofSensor(String sensor) {
        return alarms.computeIfAbsent(sensor, unseen -> new LiveAlarms(patience));
    }

    private ContactLook look(int contact, List<Observation> observations) {
        Observation first = observations.get(0);
        double probability = observations.stream()
                .mapToDouble(Observation::probability)
                .max()
                .orElse(0.0);
        assessed.add(new AssessedLook(contact, first.sensor(), first.arrival(), probability));
        List<Measurement> measurements = observations.stream()
                .flatMap(one -> one.measurements().stream())
                .toList();
        return new ContactLook(contact, first.sensor(), first.arrival(), measurements);
    }

    /**
     * A matcher of confirmed contacts: false ones of different sensors match if they agree in time and bearing.
     *
     * @param gate maximum difference between the bearings of two contacts, 0 to pi, rad; a contact without a bearing
     *     agrees with any
     * @param within maximum time between the confirmations of the two, 0 or more, s
     */
    public ContactMatcher matcher(double gate, double within) {
        return new BearingMatcher(drones::containsKey, gate, within);
    }

    /** The probability with which each of the latest looks would detect its contact, for scoring. */
    public List<AssessedLook> assessed() {
        return List.copyOf(assessed);
    }

    /** The contact of a drone, for scoring; empty when no sensor has looked at it. */
    public OptionalInt contactOf(String drone) {
        Integer contact = contacts.get(drone);
        return contact == null ? OptionalInt.empty() : OptionalInt.of(contact);
    }

    /** The drone of a contact, for scoring; empty for a false one. */
    public Optional<String> droneOf(int contact) {
        return Optional.ofNullable(drones.get(contact));
    }

    /** The contacts that ended with the latest looks: they receive no more looks. */
    public List<Integer> ended() {
        return List.copyOf(ended);
    }
}
