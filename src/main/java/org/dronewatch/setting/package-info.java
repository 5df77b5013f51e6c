/**
 * How a value that a person writes becomes a checked number: physical quantities with their units, limits, and the
 * exception that reports bad input in one line. Everything else stands on this package; it stands on nothing.
 */
package org.dronewatch.setting;
