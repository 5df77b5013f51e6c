package org.dronewatch.campaign.sensitivity;

/**
 * The elementary effects of one factor: how much a result changes, scaled to the whole range of the factor.
 *
 * @param magnitude mean of the absolute values of the effects, in units of the result: mu* (Campolongo et al.,
 *     Environmental Modelling and Software 22, 2007)
 * @param deviation standard deviation of the effects, in units of the result: above 0 if the effect depends on other
 *     factors or on the value of this one
 */
public record MorrisEffect(double magnitude, double deviation) {}
