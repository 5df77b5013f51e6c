/**
 * What a file of a placement asks for: objective, offers and conditions, and the candidates that follow from them
 * on the site.
 */
package org.dronewatch.placement.plan;
