using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Json;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Keeps the originals in a JSON file. It is written beside itself and renamed, so that at every moment it is either
/// the old one or the new one. Used on the ground only, where a slow disk delays nothing but the start.
/// </summary>
internal sealed class OriginalsFile(string path) : IOriginalsStore
{
    private const int Version = 1;
    private const long MaxLength = 10_000_000;

    public string? Load(out Originals? originals)
    {
        originals = null;
        try
        {
            if (!File.Exists(path))
                return null;
            if (new FileInfo(path).Length > MaxLength)
                return $"{path} is no file of original parameters: it is too long";
            using JsonDocument document = JsonDocument.Parse(File.ReadAllBytes(path));
            var faults = new List<string>();
            originals = Read(document.RootElement, faults);
            if (faults.Count == 0)
                return null;
            originals = null;
            return $"{path}: " + string.Join("; ", faults);
        }
        catch (JsonException e)
        {
            return $"{path} is damaged: {e.Message.Split('.')[0]}";
        }
        catch (Exception e) when (IsOfDisk(e))
        {
            return $"{path} cannot be read: {e.Message}";
        }
    }

    public string? Save(Originals originals)
    {
        string next = path + ".new";
        try
        {
            using (var file = new FileStream(next, FileMode.Create, FileAccess.Write))
            {
                Write(file, originals);
                file.Flush(flushToDisk: true);
            }

            if (File.Exists(path))
                File.Replace(next, path, destinationBackupFileName: null);
            else
                File.Move(next, path);
            return null;
        }
        catch (Exception e) when (IsOfDisk(e))
        {
            return $"{path} cannot be written: {e.Message}";
        }
    }

    public string? Delete()
    {
        try
        {
            File.Delete(path);
            return null;
        }
        catch (Exception e) when (IsOfDisk(e))
        {
            return $"{path} cannot be deleted: {e.Message}";
        }
    }

    private static bool IsOfDisk(Exception e)
        => e is IOException or UnauthorizedAccessException or NotSupportedException or ArgumentException;

    private static void Write(Stream file, Originals originals)
    {
        using var json = new Utf8JsonWriter(file, new JsonWriterOptions { Indented = true });
        json.WriteStartObject();
        json.WriteNumber("version", Version);
        json.WriteNumber("systemId", originals.SystemId);
        json.WriteStartArray("parameters");
        foreach (AutopilotParameter parameter in originals.Parameters)
        {
            json.WriteStartObject();
            json.WriteString("name", parameter.Name);
            json.WriteNumber("type", (int)parameter.Type);
            json.WriteNumber("value", parameter.Value);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        if (originals.Fence is { } fence)
            WriteFence(json, fence);
        json.WriteEndObject();
        json.Flush();
    }

    private static void WriteFence(Utf8JsonWriter json, IReadOnlyList<FenceItem> fence)
    {
        json.WriteStartArray("fence");
        foreach (FenceItem item in fence)
        {
            json.WriteStartArray();
            json.WriteNumberValue((int)item.Command);
            json.WriteNumberValue((int)item.Frame);
            foreach (float number in new[] { item.Param1, item.Param2, item.Param3, item.Param4 })
                json.WriteNumberValue(float.IsNaN(number) ? 0 : number);
            json.WriteNumberValue(item.X);
            json.WriteNumberValue(item.Y);
            json.WriteNumberValue(item.Z);
            json.WriteEndArray();
        }

        json.WriteEndArray();
    }

    private static Originals? Read(JsonElement root, List<string> faults)
    {
        if (root.ValueKind != JsonValueKind.Object)
        {
            faults.Add("it is no file of original parameters");
            return null;
        }

        var fields = new JsonFields(root, string.Empty, faults);
        double version = fields.RequiredNumber("version");
        if (faults.Count == 0 && !version.Equals(Version))
            faults.Add(FormattableString.Invariant($"version is {version}; this program reads {Version}"));
        int systemId = fields.RequiredWholeNumber("systemId");
        if (faults.Count == 0 && systemId is < 1 or > 255)
            faults.Add(FormattableString.Invariant($"systemId is {systemId}; it must be 1 to 255"));
        AutopilotParameter[] parameters = ReadParameters(fields, faults);
        FenceItem[]? fence = fields.Has("fence") ? ReadFence(fields, faults) : null;
        return faults.Count > 0 ? null : new Originals((byte)systemId, parameters, fence);
    }

    private static AutopilotParameter[] ReadParameters(JsonFields fields, List<string> faults)
    {
        if (fields.Array("parameters") is not { } list)
        {
            fields.Missing("parameters");
            return [];
        }

        var parameters = new List<AutopilotParameter>();
        foreach (JsonElement element in list.EnumerateArray())
        {
            if (element.ValueKind != JsonValueKind.Object)
            {
                faults.Add("parameters has an element that is no object");
                continue;
            }

            var item = new JsonFields(element, "parameters[].", faults);
            string name = item.Text("name") ?? string.Empty;
            double value = item.RequiredNumber("value");
            int type = item.RequiredWholeNumber("type");
            if (name.Length is 0 or > 16)
                faults.Add("parameters has an element without a name of 1 to 16 characters");
            parameters.Add(new AutopilotParameter(name, value, (MavParamType)type));
        }

        return parameters.ToArray();
    }

    private static FenceItem[] ReadFence(JsonFields fields, List<string> faults)
    {
        if (fields.Array("fence") is not { } list)
            return [];
        var items = new List<FenceItem>();
        foreach (JsonElement element in list.EnumerateArray())
        {
            if (ReadItem(element) is { } item)
                items.Add(item);
            else
                faults.Add("fence has an element that is no item of a fence");
        }

        return items.ToArray();
    }

    private static FenceItem? ReadItem(JsonElement element)
    {
        if (element.ValueKind != JsonValueKind.Array || element.GetArrayLength() != 9
            || element.EnumerateArray().Any(e => e.ValueKind != JsonValueKind.Number))
            return null;
        double[] n = element.EnumerateArray().Select(e => e.GetDouble()).ToArray();
        bool fits = Math.Abs(n[6]) <= int.MaxValue && Math.Abs(n[7]) <= int.MaxValue;
        return fits
            ? new FenceItem(
                (MavCmd)(int)n[0], (MavFrame)(int)n[1], (float)n[2], (float)n[3], (float)n[4], (float)n[5], (int)n[6],
                (int)n[7], (float)n[8])
            : null;
    }
}
