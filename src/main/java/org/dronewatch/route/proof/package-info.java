/** Routes as scenes that run, and how often runs of them detect the drone. */
package org.dronewatch.route.proof;
