/**
 * The best layout of sensors at a real site: where sensors may stand, what each covers, and the scene with the best
 * layout.
 */
package org.dronewatch.placement.site;
