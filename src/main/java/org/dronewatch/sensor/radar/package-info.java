/** The radar: its range equation, how reliably an echo is distinguished from noise, and what rain and cover take from it. */
package org.dronewatch.sensor.radar;
