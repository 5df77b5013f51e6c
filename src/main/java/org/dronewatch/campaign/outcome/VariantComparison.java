package org.dronewatch.campaign.outcome;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Two variants compared case by case, by one outcome. Cases are added one by one. For use by one thread. */
public final class VariantComparison {
    private static final int MOST_CASES = 20;

    private final String a;
    private final String b;
    private final Outcome outcome;
    private final List<Integer> deciding = new ArrayList<>();
    private final Set<Integer> decidedForA = new HashSet<>();
    private int onlyA;
    private int onlyB;
    private int both;

    VariantComparison(String a, String b, Outcome outcome) {
        this.a = a;
        this.b = b;
        this.outcome = outcome;
    }

    void add(CaseResult ofA, CaseResult ofB) {
        if (!outcome.isKnown(ofA) || !outcome.isKnown(ofB)) {
            return;
        }
        both++;
        if (outcome.isMetBy(ofA) == outcome.isMetBy(ofB)) {
            return;
        }
        onlyA += outcome.isMetBy(ofA) ? 1 : 0;
        onlyB += outcome.isMetBy(ofB) ? 1 : 0;
        if (deciding.size() < MOST_CASES) {
            deciding.add(ofA.number());
            if (outcome.isMetBy(ofA)) {
                decidedForA.add(ofA.number());
            }
        }
    }

    /** The first variant. */
    public String a() {
        return a;
    }

    /** The second variant. */
    public String b() {
        return b;
    }

    /** The outcome by which the variants are compared. */
    public Outcome outcome() {
        return outcome;
    }

    /** Whether there are cases in which the outcome is known for both variants. */
    public boolean isKnown() {
        return both > 0;
    }

    /** The result. */
    public PairedDifference difference() {
        return new PairedDifference(onlyA, onlyB, both);
    }

    /**
     * The variant that has the outcome in a given case, while the other variant does not.
     *
     * @param number number of the case, one of {@link #deciding()}
     */
    public String betterIn(int number) {
        return decidedForA.contains(number) ? a : b;
    }

    /** The first 20 cases in which the variants differ. */
    public List<Integer> deciding() {
        return Collections.unmodifiableList(deciding);
    }
}
