/**
 * The best layout of sensors at a real site: where sensors may be installed, what each covers, and the scene with the
 * best layout.
 */
package org.dronewatch.placement.site;
