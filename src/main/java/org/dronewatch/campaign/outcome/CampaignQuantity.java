package org.dronewatch.campaign.outcome;

/** A number that every case has, whose variation can be explained. */
public enum CampaignQuantity {
    /** The warning time, s; 0 without an alert. */
    WARNING_S("warning time", "s"),
    /** The range of the first detection, m; 0 without one. */
    RANGE_M("range of the first detection", "m"),
    /** 1 in a case in which a sensor detects an attacking drone, otherwise 0. */
    DETECTED("detection", ""),
    /** 1 in a case with an alert, otherwise 0. */
    ALERTED("alert", ""),
    /** 1 in a case with an alert in time, otherwise 0. */
    IN_TIME("timeliness of the alert", "");

    private final String words;
    private final String unit;

    CampaignQuantity(String words, String unit) {
        this.words = words;
        this.unit = unit;
    }

    /** The name of the quantity in reports. */
    public String words() {
        return words;
    }

    /** The unit of the quantity; empty for those that are 0 or 1. */
    public String unit() {
        return unit;
    }

    /** The value of the quantity in a case that did not fail. */
    public double of(CaseResult result) {
        return switch (this) {
            case WARNING_S -> result.warning().orElse(0.0);
            case RANGE_M -> result.range().orElse(0.0);
            case DETECTED -> Outcome.DETECTED.isMetBy(result) ? 1.0 : 0.0;
            case ALERTED -> Outcome.ALERTED.isMetBy(result) ? 1.0 : 0.0;
            case IN_TIME -> Outcome.IN_TIME.isMetBy(result) ? 1.0 : 0.0;
        };
    }
}
