/**
 * What a placement file asks for: objective, offers and conditions, and the candidates that follow from them on the
 * site.
 */
package org.dronewatch.placement.plan;
