package org.dronewatch.report.campaign;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignResult;
import org.dronewatch.campaign.Sensitivity;
import org.dronewatch.campaign.Stopping;
import org.dronewatch.campaign.outcome.FailedCases;
import org.dronewatch.campaign.outcome.Measures;
import org.dronewatch.campaign.outcome.Outcome;
import org.dronewatch.campaign.outcome.PairedDifference;
import org.dronewatch.campaign.outcome.UntilSettings;
import org.dronewatch.campaign.outcome.VariantComparison;
import org.dronewatch.campaign.outcome.VariantSummary;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.statistics.Proportion;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The contents of {@code campaign.json}. */
public final class CampaignFile {
    /** The confidence of all intervals. */
    static final double CONFIDENCE = 0.95;

    private static final int FORMAT = 1;
    private static final double SECTOR_DEG = 360.0 / VariantSummary.SECTORS;

    private final CampaignPlan plan;
    private final CampaignResult result;

    /** The contents for all cases that were run. */
    public CampaignFile(CampaignPlan plan, CampaignResult result) {
        this.plan = plan;
        this.result = result;
    }

    /** The contents, with all keys. */
    public ObjectNode toJson() {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("format", FORMAT);
        root.put("scene", plan.settings().scene());
        root.put("seed", plan.settings().seed());
        root.put("runs", plan.size());
        root.put("confidence", CONFIDENCE);
        plan.settings().until().ifPresent(until -> add(root.putObject("until"), until));
        ObjectNode variants = root.putObject("variants");
        result.summary().variants().forEach((name, variant) -> add(variants.putObject(name), variant));
        ArrayNode pairs = root.putArray("pairs");
        result.summary().comparisons().forEach(pair -> add(pairs.addObject(), pair));
        result.sensitivity().ifPresent(sensitivity -> {
            root.put("sensitivity_of", sensitivity.settings().output().name().toLowerCase(Locale.ROOT));
            root.put("sensitivity_variant", sensitivity.variant());
            ArrayNode influences = root.putArray("sensitivity");
            sensitivity.influences().forEach(one -> add(influences.addObject(), one));
        });
        root.put("complete", isComplete());
        return root;
    }

    /** Whether all cases were run. */
    boolean isComplete() {
        boolean isExplained =
                plan.sensitivity().isEmpty() || result.sensitivity().isPresent();
        return result.stopping().isReached() && isExplained;
    }

    private void add(ObjectNode node, UntilSettings until) {
        Stopping stopping = result.stopping();
        Proportion proportion = stopping.proportion();
        Proportion.Interval interval = until.rule().interval(proportion);
        node.put("of", key(until.of()));
        node.put("variant", plan.observed());
        node.put("half_width", Numbers.rounded(until.halfWidth()));
        node.put("confidence", Numbers.rounded(until.confidence()));
        node.put("reached", stopping.isPrecise());
        node.put("k", proportion.count());
        node.put("n", proportion.of());
        if (stopping.isPrecise()) {
            node.put("share", Numbers.rounded(proportion.share()));
            node.put("low", Numbers.rounded(interval.low()));
            node.put("high", Numbers.rounded(interval.high()));
        }
    }

    private static void add(ObjectNode node, VariantSummary variant) {
        node.put("n", variant.cases());
        node.put("failed", variant.failed());
        node.put("cut_short", variant.cutShort());
        ArrayNode failures = node.putArray("failures");
        for (FailedCases.Reason reason : variant.failures()) {
            ObjectNode one = failures.addObject();
            one.put("error", reason.words());
            one.put("case", reason.example());
            one.put("cases", reason.cases());
        }
        for (Outcome outcome : Outcome.values()) {
            put(node, key(outcome), variant.proportion(outcome));
        }
        put(node.putObject("range_m"), variant.ranges());
        put(node.putObject("warning_s"), variant.warnings());
        ArrayNode bearings = node.putArray("by_bearing");
        for (int sector = 0; sector < VariantSummary.SECTORS; sector++) {
            ObjectNode one = bearings.addObject();
            one.put("bearing_deg", Numbers.rounded(sector * SECTOR_DEG));
            for (Outcome outcome : Outcome.values()) {
                put(one, key(outcome), variant.proportion(outcome, sector));
            }
        }
        ObjectNode drones = node.putObject("by_drone");
        for (String drone : variant.drones()) {
            ObjectNode one = drones.putObject(drone);
            for (Outcome outcome : Outcome.values()) {
                put(one, key(outcome), variant.proportion(outcome, drone));
            }
        }
        ObjectNode sensors = node.putObject("by_sensor");
        variant.firstSensors().forEach(sensors::put);
    }

    private static void add(ObjectNode node, Sensitivity.Influence influence) {
        node.put("path", influence.path());
        influence.index().ifPresent(index -> {
            node.put("first", Numbers.rounded(index.first()));
            node.put("low", Numbers.rounded(index.low()));
            node.put("high", Numbers.rounded(index.high()));
            node.put("total", Numbers.rounded(index.total()));
            node.put("total_low", Numbers.rounded(index.totalLow()));
            node.put("total_high", Numbers.rounded(index.totalHigh()));
        });
        influence.effect().ifPresent(effect -> {
            node.put("mu_star", Numbers.rounded(effect.magnitude()));
            node.put("sigma", Numbers.rounded(effect.deviation()));
        });
    }

    private static void add(ObjectNode node, VariantComparison pair) {
        PairedDifference difference = pair.difference();
        Proportion.Interval interval = difference.interval(CONFIDENCE);
        node.put("a", pair.a());
        node.put("b", pair.b());
        node.put("of", key(pair.outcome()));
        node.put("n", difference.of());
        node.put("only_a", difference.onlyA());
        node.put("only_b", difference.onlyB());
        node.put("difference", Numbers.rounded(difference.difference()));
        node.put("low", Numbers.rounded(interval.low()));
        node.put("high", Numbers.rounded(interval.high()));
        node.put("p", Numbers.rounded(difference.pValue()));
        ArrayNode cases = node.putArray("cases");
        pair.deciding().forEach(cases::add);
    }

    private static void put(ObjectNode node, String key, Optional<Proportion> proportion) {
        if (proportion.isEmpty()) {
            node.putNull(key);
            return;
        }
        ObjectNode one = node.putObject(key);
        Proportion.Interval interval = proportion.get().wilson(CONFIDENCE);
        one.put("k", proportion.get().count());
        one.put("n", proportion.get().of());
        one.put("share", Numbers.rounded(proportion.get().share()));
        one.put("low", Numbers.rounded(interval.low()));
        one.put("high", Numbers.rounded(interval.high()));
    }

    private static void put(ObjectNode node, Measures measures) {
        put(node, "p5", measures.quantile(0.05));
        put(node, "p50", measures.quantile(0.5));
        put(node, "p95", measures.quantile(0.95));
    }

    private static void put(ObjectNode node, String key, OptionalDouble value) {
        if (value.isPresent()) {
            node.put(key, Numbers.rounded(value.getAsDouble()));
        } else {
            node.putNull(key);
        }
    }

    private static String key(Outcome outcome) {
        return outcome.name().toLowerCase(Locale.ROOT);
    }
}
