/** Routes as scenes that can be run, and how often runs of them detect the drone. */
package org.dronewatch.route.proof;
