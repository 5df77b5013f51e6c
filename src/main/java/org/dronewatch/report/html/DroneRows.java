package org.dronewatch.report.html;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.ThreatLabel;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.Choices;

/** The table of all drones and swarms. */
final class DroneRows {
    private static final String UNKNOWN = "unknown";
    private static final List<String> HEAD =
            List.of("drone", "model", "speed", "sound", "radar cross-section", "heat", "control", "label");

    private DroneRows() {}

    static String table(SceneSettings scene) {
        List<List<String>> rows = new ArrayList<>();
        Map<String, DroneSettings> fliers = scene.fliers();
        for (DroneGroup group : DroneGroup.of(scene)) {
            DroneSettings drone = fliers.get(group.members().get(0));
            rows.add(List.of(
                    group.isSwarm()
                            ? group.name() + " (swarm of " + group.members().size() + ")"
                            : group.name(),
                    drone.model().file(),
                    ReadableNumbers.number(drone.speed()) + " m/s",
                    sound(drone),
                    drone.radar().crossSection() + " m\u00b2",
                    ReadableNumbers.number(drone.heat().excess()) + " K",
                    drone.radio().control().toString().toLowerCase(Locale.ROOT),
                    label(drone.label())));
        }
        return Html.table(HEAD, rows);
    }

    private static String sound(DroneSettings drone) {
        return ReadableNumbers.number(drone.soundPowerLevel()) + " dB(A) sound power; "
                + ReadableNumbers.number(drone.soundLevel()) + " dB in the level model";
    }

    /** Its label: {@code attack, strike, fixed-wing, battery, 5 kg, 1.5 m}. */
    private static String label(ThreatLabel label) {
        Stream<String> words = Stream.of(label.role(), label.purpose(), label.platform(), label.powerSource())
                .map(part -> Choices.name(part.name()))
                .filter(word -> !word.equals(UNKNOWN));
        Stream<String> weight = label.weight().stream().map(kg -> ReadableNumbers.number(kg) + " kg");
        Stream<String> size = label.size().stream().map(metres -> ReadableNumbers.number(metres) + " m");
        return Stream.of(words, weight, size).flatMap(part -> part).collect(Collectors.joining(", "));
    }
}
