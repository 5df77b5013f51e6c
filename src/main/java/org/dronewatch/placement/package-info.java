/** The best layout for the money: candidates, what each contributes, conditions, and what is to be made best. */
package org.dronewatch.placement;
