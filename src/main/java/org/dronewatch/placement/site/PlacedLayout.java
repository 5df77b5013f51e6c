package org.dronewatch.placement.site;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.SiteCandidate;

/**
 * The best layout that was found for a plan, with any objective. Values are in the unit of the objective (fractions,
 * times in s or exposures), and greater values are better.
 */
public interface PlacedLayout {
    /** What was asked for. */
    PlacePlan plan();

    /** The cells in which candidates were assessed. */
    FieldGrid grid();

    /** The result of the search, whose values are in the unit of its problem. */
    PlacementResult result();

    /** The scene's own sensors; empty if it has none, or if the search was interrupted before they were assessed. */
    Optional<PresentLayout> present();

    /** Whether every candidate and the scene's own sensors were assessed, and the search ran to completion. */
    boolean complete();

    /** The number of candidates that were assessed: all of them, unless the search was interrupted. */
    default int assessed() {
        return plan().candidates().size();
    }

    /** The value of the layout. */
    double value();

    /** The value that no layout within the budget exceeds. */
    double bound();

    /** The value of a chosen sensor by itself; empty if it was not computed. */
    OptionalDouble alone(SiteCandidate sensor);

    /** The value of only some of the layout's sensors; empty if it was not computed. */
    default OptionalDouble together(List<SiteCandidate> sensors) {
        return OptionalDouble.empty();
    }

    /** The value that remains without each of the sensors, by their names; empty if it was not computed. */
    Map<String, Double> withoutEach();

    /**
     * The best order in which to buy the sensors, after those that are kept, by the {@linkplain #buyingRule rule} of
     * the objective. Empty if it was not computed.
     */
    List<PlaceStep> purchases();

    /**
     * Purchases after which the layout does not yet comply with the conditions; empty if there are none, or it is not
     * known.
     */
    default Optional<EarlyPurchases> early() {
        return Optional.empty();
    }

    /** How the order in which to buy is found. */
    default BuyingRule buyingRule() {
        return BuyingRule.of(plan().settings());
    }

    /** The value of the layout under each condition, by name; empty if only the scene as it is counts. */
    default Map<String, Double> byCondition() {
        return Map.of();
    }

    /** The value of the layout in the scene as it is. */
    default double asItIs() {
        return value();
    }

    /** The sensors of the layout, in the order of the file. */
    default List<SiteCandidate> chosen() {
        return result().chosen().stream().map(plan().candidates()::get).toList();
    }

    /**
     * By how much the bound exceeds the value, as a fraction of the value: 0 if it does not, otherwise infinite for a
     * value of 0.
     */
    default double gap() {
        return bound() <= value() ? 0.0 : bound() / value() - 1.0;
    }
}
