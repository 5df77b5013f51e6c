/** The best layout of a real place: where sensors may stand, what each covers, and the scene with the best of them. */
package org.dronewatch.placement.site;
