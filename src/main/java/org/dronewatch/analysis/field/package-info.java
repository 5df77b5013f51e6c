/** The detection field of a site: where, how high and how early its sensors detect a drone, and why not elsewhere. */
package org.dronewatch.analysis.field;
