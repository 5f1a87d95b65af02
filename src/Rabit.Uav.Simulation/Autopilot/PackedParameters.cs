using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// ArduPilot's file of all parameters, @PARAM/param.pck, which ground stations read in place of a list (ArduPilot,
/// AP_Filesystem/README.md): a header, then of each parameter its type, how much of its name is that of the one before,
/// the rest of its name, and its value.
/// </summary>
internal static class PackedParameters
{
    public const string Path = "@PARAM/param.pck";

    private const ushort Magic = 0x671B;
    private const ushort MagicWithDefaults = 0x671C;
    private const int HasDefault = 0x10;
    private const int MaxCommon = 15;

    // The data of one packet of a file transfer: no value lies in two, so that a packet that is read again later never
    // leaves half of an older value.
    private const int BlockLength = 239;

    /// <summary>The file, by a name that may have arguments: <c>param.pck?start=10&amp;count=5</c>.</summary>
    /// <returns>Null where there is none of that name.</returns>
    public static byte[]? Find(ParameterStore parameters, string path)
    {
        if (!path.StartsWith(Path, StringComparison.Ordinal))
            return null;
        string query = path.Substring(Path.Length);
        (int start, int count, bool hasDefaults) = (0, 0, false);
        if (query.Length > 0 && (query[0] != '?' || !TryRead(query, ref start, ref count, ref hasDefaults)))
            return null;
        return start < parameters.Count ? Write(parameters, start, count, hasDefaults) : null;
    }

    private static bool TryRead(string query, ref int start, ref int count, ref bool hasDefaults)
    {
        foreach (string argument in query.Substring(1).Split('&'))
        {
            string[] parts = argument.Split('=');
            if (parts.Length != 2
                || !ushort.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out ushort value))
                return false;
            switch (parts[0])
            {
                case "start": start = value; break;
                case "count": count = value; break;
                case "withdefaults": hasDefaults = value == 1; break;
            }
        }

        return true;
    }

    private static byte[] Write(ParameterStore parameters, int start, int count, bool hasDefaults)
    {
        int end = count > 0 ? Math.Min(parameters.Count, start + count) : parameters.Count;
        var file = new List<byte>();
        Add(file, hasDefaults ? MagicWithDefaults : Magic);
        Add(file, (ushort)(end - start));
        Add(file, (ushort)parameters.Count);
        string before = string.Empty;
        for (int index = start; index < end; index++)
        {
            Parameter parameter = parameters[index];
            int common = Common(before, parameter.Name);
            before = parameter.Name;
            byte[] rest = Encoding.ASCII.GetBytes(parameter.Name.Substring(common));
            byte[] value = Bytes(parameter.Type, parameter.Value);
            bool hasDefault = hasDefaults && !parameter.Value.Equals(parameter.Default);
            Pad(file, 2 + rest.Length + (hasDefault ? 2 * value.Length : value.Length), value.Length);
            file.Add((byte)(TypeOf(parameter.Type) | (hasDefault ? HasDefault : 0)));
            file.Add((byte)(common | ((rest.Length - 1) << 4)));
            file.AddRange(rest);
            file.AddRange(value);
            if (hasDefault)
                file.AddRange(Bytes(parameter.Type, parameter.Default));
        }

        return file.ToArray();
    }

    private static void Add(List<byte> file, ushort number)
    {
        file.Add((byte)number);
        file.Add((byte)(number >> 8));
    }

    // At least one character of the name is always there.
    private static int Common(string before, string name)
    {
        int common = 0;
        while (common < MaxCommon && common < name.Length - 1 && common < before.Length
            && before[common] == name[common])
            common++;
        return common;
    }

    private static void Pad(List<byte> file, int length, int valueLength)
    {
        int beyond = (file.Count + length) % BlockLength;
        for (int i = beyond; valueLength > 1 && beyond > 0 && i < valueLength; i++)
            file.Add(0);
    }

    private static int TypeOf(MavParamType type) => type switch
    {
        MavParamType.Int8 => 1,
        MavParamType.Int16 => 2,
        MavParamType.Int32 => 3,
        _ => 4,
    };

    private static byte[] Bytes(MavParamType type, float value) => type switch
    {
        MavParamType.Int8 => [(byte)(sbyte)value],
        MavParamType.Int16 => BitConverter.GetBytes((short)value),
        MavParamType.Int32 => BitConverter.GetBytes((int)value),
        _ => BitConverter.GetBytes(value),
    };
}
