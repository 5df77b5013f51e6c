/** Statistics that campaigns and routes share. */
package org.dronewatch.statistics;
