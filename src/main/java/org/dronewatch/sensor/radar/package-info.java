/** The radar: its range equation, how surely an echo is told from noise, and what rain and cover take from it. */
package org.dronewatch.sensor.radar;
