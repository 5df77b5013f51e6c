/** The best layout for the money: candidates, what each contributes, conditions, and an objective. */
package org.dronewatch.placement;
