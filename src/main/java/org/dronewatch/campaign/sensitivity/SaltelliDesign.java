package org.dronewatch.campaign.sensitivity;

/**
 * Saltelli's design for Sobol indices (Saltelli et al., Computer Physics Communications 181, 2010): in each group,
 * first all factors have their first value, then all have their second, and then each factor in turn is the only one
 * with its second value; the values are independent random numbers.
 *
 * @param factors number of factors, 1 or more
 * @param base number of groups, 2 or more
 * @param values uniform random numbers, used as the cumulative probabilities of the factors' values
 */
public record SaltelliDesign(int factors, int base, Uniform01 values) implements FactorDesign {
    /** Evaluations of a group besides one for each factor. */
    static final int BOTH = 2;

    /** Checks the limits. */
    public SaltelliDesign {
        if (factors < 1 || base < 2) {
            throw new IllegalArgumentException(factors + " factors, base " + base
                    + ": there must be at least one factor, and a base of 2 or more");
        }
    }

    @Override
    public int groupSize() {
        return factors + BOTH;
    }

    @Override
    public boolean isSecond(int evaluation, int factor) {
        int which = evaluation % groupSize();
        return which == 1 || which == factor + BOTH;
    }

    @Override
    public double quantile(int evaluation, int factor) {
        return values.draw(group(evaluation), factor, isSecond(evaluation, factor));
    }
}
