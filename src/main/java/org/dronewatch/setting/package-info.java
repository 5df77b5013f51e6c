/**
 * Settings records and the checks of their values: physical quantities with units, limits, and the exception that
 * reports wrong input, one line for each mistake. All other packages depend on this one; it depends on none.
 */
package org.dronewatch.setting;
