package org.dronewatch.viewer;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.SiteState;

/**
 * The sensor or drone that a click selects. Where symbols cover each other, such as those of sensors on one mast, each
 * further click on the same place selects the next.
 *
 * @param chosen its name; empty if no symbol is near
 * @param number its number among those that cover each other, from 1; 0 if no symbol is near
 * @param together how many cover each other
 */
record SymbolPick(Optional<String> chosen, int number, int together) {
    /** Symbols cover each other if the pointer is nearly as far from one as from the other, in pixels. */
    private static final double SAME = 3.0;

    private record Symbol(String id, double distance) {}

    /**
     * Picks a symbol.
     *
     * @param state what is drawn, with what is selected
     * @param distance distance of a place from the pointer, in pixels
     * @param near distance within which a symbol is hit, in pixels
     */
    static SymbolPick of(SiteState state, ToDoubleFunction<Position> distance, double near) {
        List<Symbol> hit = new ArrayList<>();
        state.drones()
                .forEach(mark -> hit.add(new Symbol(
                        mark.drone().id(), distance.applyAsDouble(mark.drone().origin()))));
        state.sensors().forEach(mark -> hit.add(new Symbol(mark.id(), distance.applyAsDouble(mark.position()))));
        hit.removeIf(symbol -> symbol.distance() >= near);
        if (hit.isEmpty()) {
            return new SymbolPick(Optional.empty(), 0, 0);
        }
        double nearest = hit.stream().mapToDouble(Symbol::distance).min().orElseThrow();
        hit.removeIf(symbol -> symbol.distance() > nearest + SAME);
        List<String> ids = hit.stream().map(Symbol::id).toList();
        int before = state.selected().map(ids::indexOf).orElse(-1);
        int next = before >= 0 ? (before + 1) % ids.size() : first(hit);
        return new SymbolPick(Optional.of(ids.get(next)), next + 1, ids.size());
    }

    private static int first(List<Symbol> hit) {
        return hit.indexOf(
                hit.stream().min(Comparator.comparingDouble(Symbol::distance)).orElseThrow());
    }

    /** How to reach the others; empty if there is no other. */
    Optional<String> hint() {
        return chosen.filter(id -> together > 1)
                .map(id -> "'" + id + "', " + number + " of " + together + " here: click again for the next one");
    }
}
