package org.dronewatch.report.placement;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.drone.RadioLink;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.SiteCandidate;
import org.dronewatch.placement.site.PlacedLayout;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.file.ShellWord;
import org.dronewatch.sensor.RadioReceiving;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * What a layout is worth against a drone that resembles the planned one but transmits nothing: the radio receivers of
 * the layout do not detect such a drone, however much they contribute against one that does transmit.
 *
 * @param layout the layout
 * @param measure describes its values
 */
record SilentDrone(PlacedLayout layout, PlaceMeasure measure) {
    /** The sensors of the layout that a silent drone evades; none if the planned drone transmits nothing anyway. */
    private List<SiteCandidate> receivers() {
        PlacePlan plan = layout.plan();
        RadioLink radio = plan.present().individualDrones().get(plan.drone()).radio();
        return radio.emits()
                ? layout.chosen().stream().filter(SilentDrone::receives).toList()
                : List.of();
    }

    private static boolean receives(SiteCandidate sensor) {
        return sensor.sensor().as(RadioReceiving.class).isPresent();
    }

    /** The value of the other sensors; empty if it was not computed. */
    private OptionalDouble others() {
        List<SiteCandidate> others =
                layout.chosen().stream().filter(sensor -> !receives(sensor)).toList();
        return others.isEmpty() ? OptionalDouble.of(0.0) : layout.together(others);
    }

    /**
     * What the layout achieves against such a drone, in a sentence; empty if it has no receivers or, in print, is worth
     * as much without them.
     */
    Optional<String> sentence() {
        int count = receivers().size();
        OptionalDouble others = others();
        boolean isSame =
                others.isPresent() && measure.text(others.getAsDouble()).equals(measure.text(layout.value()));
        if (count == 0 || isSame) {
            return Optional.empty();
        }
        String detecting = "Against a drone that transmits nothing (autonomous, or controlled by fibre), the layout's "
                + (count == 1 ? "radio receiver detects" : count + " radio receivers detect") + " nothing";
        return Optional.of(detecting + remaining(count, others) + "." + hint());
    }

    private String remaining(int receivers, OptionalDouble others) {
        if (others.isPresent()) {
            return ": the layout then " + measure.claim(true, others.getAsDouble()) + measure.headingsClause();
        }
        int left = layout.chosen().size() - receivers;
        return left == 1 ? ": only its other sensor counts" : ": only its " + left + " other sensors count";
    }

    /** How to choose a layout against such a drone; empty for a drone of a swarm, whose settings are not individual. */
    private String hint() {
        String drone = layout.plan().drone();
        return layout.plan().present().drones().containsKey(drone)
                ? " For the best layout against it, run place with --set "
                        + ShellWord.of("drones." + drone + ".radio.control=autonomous")
                : "";
    }

    /** Adds {@code silent_drone} where the sentence has something to say. */
    void add(ObjectNode root) {
        if (sentence().isPresent()) {
            ObjectNode silent = root.putObject("silent_drone");
            ArrayNode receivers = silent.putArray("receivers");
            receivers().forEach(sensor -> receivers.add(sensor.name()));
            OptionalDouble others = others();
            silent.put("value", others.isPresent() ? Numbers.rounded(others.getAsDouble()) : null);
        }
    }
}
