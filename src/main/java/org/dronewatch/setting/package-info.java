/**
 * Settings records and the checks of their values: physical quantities with units, limits, and the exception that
 * reports wrong input, one line for each mistake. Most other packages depend on this one, which depends on none.
 */
package org.dronewatch.setting;
