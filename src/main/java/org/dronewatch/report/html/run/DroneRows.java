package org.dronewatch.report.html.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RadarSignature;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.ReadableNumbers;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.Choices;
import org.dronewatch.setting.Quantity;

/** The table of all drones and swarms. */
final class DroneRows {
    private static final List<String> HEAD = List.of(
            "drone",
            "model",
            "speed",
            "sound",
            "radar cross-section",
            "temperature above background",
            "control",
            "label");

    private DroneRows() {}

    static String table(SceneSettings scene) {
        List<List<String>> rows = new ArrayList<>();
        Map<String, DroneSettings> individuals = scene.individualDrones();
        for (DroneGroup group : DroneGroup.all(scene)) {
            DroneSettings drone = individuals.get(group.members().get(0));
            rows.add(List.of(
                    group.isSwarm()
                            ? group.name() + " (" + (drone.isBird() ? "flock" : "swarm") + " of "
                                    + group.members().size() + ")"
                            : group.name(),
                    drone.model().file(),
                    ReadableNumbers.number(drone.speed()) + " m/s",
                    sound(drone),
                    crossSection(drone.radar()),
                    ReadableNumbers.number(drone.heat().excess()) + " K",
                    drone.radio().control().toString().toLowerCase(Locale.ROOT),
                    drone.label().inWords()));
        }
        return Html.table(HEAD, rows);
    }

    private static String crossSection(RadarSignature radar) {
        String rotors = radar.rotorLevel()
                .map(level -> ", rotors " + ReadableNumbers.number(level) + " dB below the body")
                .orElse("");
        return radar.droneClass()
                        .map(one -> Quantity.NUMBER.inBrief(one.crossSection()) + " m\u00b2, spread "
                                + ReadableNumbers.number(one.spread()) + " dB")
                        .orElseGet(() -> radar.crossSection() + " m\u00b2"
                                + radar.spread()
                                        .map(one -> ", spread " + ReadableNumbers.number(one) + " dB")
                                        .orElse(""))
                + rotors;
    }

    private static String sound(DroneSettings drone) {
        String levels = ReadableNumbers.number(drone.soundPowerLevel()) + " dB(A) sound power; "
                + ReadableNumbers.number(drone.soundLevel()) + " dB in the level model";
        return drone.emission().isStatedBySettings()
                ? levels
                : levels + "; emission " + Choices.nameOf(drone.emission().getClass());
    }
}
