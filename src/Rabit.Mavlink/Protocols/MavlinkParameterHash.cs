using System;

namespace Rabit.Mavlink;

/// <summary>
/// The hash that PX4 sends in front of its list as _HASH_CHECK: CRC-32 over the names and the four bytes of all values,
/// in the order of the names, without those that PX4 changes by itself (PX4, <c>param_hash_check</c>). It shows whether
/// a list that was kept is still the vehicle's. Any thread.
/// </summary>
public static class MavlinkParameterHash
{
    // Reflected; begins at 0 and is not inverted at the end.
    private const uint Polynomial = 0xEDB88320;
    private const int BitsPerByte = 8;
    private const int ValueLength = 4;

    /// <summary>Computes the hash of a list.</summary>
    /// <param name="parameters">The list, as received; values byte by byte, as PX4 sends them.</param>
    /// <param name="isVolatile">
    /// Which parameters the vehicle leaves out; <see cref="IsVolatile"/> where null. Another firmware may have others.
    /// </param>
    /// <returns>The hash; it means nothing while parameters are missing.</returns>
    /// <exception cref="ArgumentNullException">No list.</exception>
    public static uint Compute(MavlinkParameterTable parameters, Predicate<string>? isVolatile = null)
    {
        if (parameters is null)
            throw new ArgumentNullException(nameof(parameters));
        isVolatile ??= IsVolatile;
        var entries = new (string Name, uint Bits)[parameters.Count];
        for (int i = 0; i < entries.Length; i++)
            entries[i] = (parameters[i].Name.ToString(), parameters[i].Bits);
        Array.Sort(entries, (a, b) => string.CompareOrdinal(a.Name, b.Name));

        uint hash = 0;
        foreach ((string name, uint bits) in entries)
        {
            if (!isVolatile(name))
                hash = Add(Add(hash, name), bits);
        }

        return hash;
    }

    /// <summary>
    /// Whether PX4 leaves a parameter out, since it changes it by itself: what it measures of its sensors and of the
    /// flight. As of PX4 1.14.
    /// </summary>
    /// <param name="name">The name.</param>
    /// <returns>False also for names that PX4 does not have.</returns>
    /// <exception cref="ArgumentNullException">No name.</exception>
    public static bool IsVolatile(string name) => (name ?? throw new ArgumentNullException(nameof(name))) switch
    {
        "COM_FLIGHT_UUID" or "EKF2_MAG_DECL" or "LND_FLIGHT_T_HI" or "LND_FLIGHT_T_LO" or "SENS_DPRES_OFF" => true,
        _ when Begins(name, "ASPD_SCALE_") => true,
        _ =>
            IsOfASensor(name)
                && (Ends(name, "OFF") || Ends(name, "SCALE") || Ends(name, "ODIAG") || Ends(name, "COMP")),
    };

    // CAL_ACC0_XOFF, CAL_MAG1_ZODIAG, CAL_BARO0_OFF; but not CAL_MAG_COMP_TYP.
    private static bool IsOfASensor(string name)
    {
        int length = Begins(name, "CAL_ACC") || Begins(name, "CAL_MAG") ? 7
            : Begins(name, "CAL_GYRO") || Begins(name, "CAL_BARO") ? 8
            : int.MaxValue;
        return name.Length > length && name[length] is >= '0' and <= '9';
    }

    private static bool Begins(string name, string with) => name.StartsWith(with, StringComparison.Ordinal);

    private static bool Ends(string name, string with) => name.EndsWith(with, StringComparison.Ordinal);

    internal static uint Add(uint hash, string name)
    {
        foreach (char character in name)
            hash = Add(hash, (byte)character);
        return hash;
    }

    internal static uint Add(uint hash, uint bits)
    {
        for (int i = 0; i < ValueLength; i++)
            hash = Add(hash, (byte)(bits >> (i * BitsPerByte)));
        return hash;
    }

    internal static uint Add(uint hash, byte value)
    {
        hash ^= value;
        for (int bit = 0; bit < BitsPerByte; bit++)
            hash = (hash & 1) != 0 ? (hash >> 1) ^ Polynomial : hash >> 1;
        return hash;
    }
}
