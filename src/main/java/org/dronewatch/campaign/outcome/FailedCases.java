package org.dronewatch.campaign.outcome;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Why cases could not be run. Reasons that differ only in their numbers count as one, and if there are many reasons,
 * only the first are kept. For use by one thread.
 */
public final class FailedCases {
    private static final int MOST_REASONS = 10;
    private static final String OTHERS = "other reasons";

    private final Map<String, Reason> reasons = new LinkedHashMap<>();

    /**
     * A reason.
     *
     * @param words the reason, as given for one of the cases
     * @param example number of that case
     * @param cases how many cases failed for this reason
     */
    public record Reason(String words, int example, int cases) {
        Reason with(int number, String others) {
            return new Reason(number < example ? others : words, Math.min(number, example), cases + 1);
        }
    }

    void add(CaseResult result) {
        String words = result.error().orElse("");
        String kind = words.replaceAll("[-+]?\\d[\\d.,]*(?:[eE][-+]?\\d+)?", "#");
        boolean isKept = reasons.containsKey(kind) || reasons.size() < MOST_REASONS;
        String shown = isKept ? words : OTHERS;
        Reason first = new Reason(shown, result.number(), 1);
        reasons.merge(isKept ? kind : OTHERS, first, (known, one) -> known.with(result.number(), shown));
    }

    /** The reasons, in the order in which they occurred. */
    public List<Reason> reasons() {
        return new ArrayList<>(reasons.values());
    }
}
