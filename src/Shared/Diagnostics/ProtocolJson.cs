using System.Text.Json;
using System.Text.Json.Serialization;

namespace Rabit.Diagnostics.Protocol;

/// <summary>The lines of the protocol as JSON, by generated code.</summary>
[JsonSourceGenerationOptions(
    PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase,
    DefaultIgnoreCondition = JsonIgnoreCondition.WhenWritingNull,
    MaxDepth = 16)]
[JsonSerializable(typeof(HelloLine))]
[JsonSerializable(typeof(RequestLine))]
[JsonSerializable(typeof(SampleLine))]
[JsonSerializable(typeof(GraphLine))]
[JsonSerializable(typeof(ErrorLine))]
internal sealed partial class ProtocolJson : JsonSerializerContext;
