using System.Collections.Generic;
using System.ComponentModel;
using Rabit.Mavlink.Definitions;

namespace Rabit.Mavlink;

/// <summary>
/// Makes the dialects of generated code. The text is the generator's, of the same version as this package.
/// </summary>
[EditorBrowsable(EditorBrowsableState.Never)]
public static class MavlinkDialectData
{
    /// <summary>Makes a dialect.</summary>
    /// <param name="data">What the generator wrote.</param>
    /// <param name="basis">
    /// The dialect whose messages and enums it uses without having them itself; null for none.
    /// </param>
    /// <returns>The dialect.</returns>
    /// <exception cref="System.InvalidOperationException">
    /// The text is that of another version: compile the project again.
    /// </exception>
    public static MavlinkDialect Create(string data, MavlinkDialect? basis)
    {
        var definitions = new DefinitionData(data);
        var messages = new List<MavlinkMessageInfo>(definitions.Messages.Count + definitions.BasisIds.Count);
        foreach (int id in definitions.BasisIds)
        {
            if (basis is null || !basis.TryGetMessage(id, out MavlinkMessageInfo message))
                throw DefinitionData.OtherVersion();
            messages.Add(message);
        }

        for (int index = 0; index < definitions.Messages.Count; index++)
            messages.Add(definitions.Messages[index]);
        return new MavlinkDialect(definitions.DialectName, messages, definitions, basis);
    }
}
