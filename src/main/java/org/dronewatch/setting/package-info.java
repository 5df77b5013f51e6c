/**
 * How a value that a person writes becomes a checked number: physical quantities with their units, limits, and the
 * exception that reports bad input in one line. All other packages depend on this one; it depends on none.
 */
package org.dronewatch.setting;
