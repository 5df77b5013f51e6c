/**
 * The radar: its range equation, how reliably an echo is distinguished from noise, and how rain and cover weaken it.
 */
package org.dronewatch.sensor.radar;
