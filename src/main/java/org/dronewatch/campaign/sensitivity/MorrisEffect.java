package org.dronewatch.campaign.sensitivity;

/**
 * The elementary effects of one factor: how much a result changes, scaled to the whole range of the factor.
 *
 * @param magnitude mean of their absolute values, in units of the result: mu* (Campolongo et al., Environmental
 *     Modelling and Software 22, 2007)
 * @param deviation their standard deviation: above 0 if the effect depends on other factors or on the value of this one
 */
public record MorrisEffect(double magnitude, double deviation) {}
