using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Naming;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests.Generator;
using Xunit;

namespace Rabit.Mavlink.Tests.Messages;

public class EnumTests
{
    [Fact]
    public void Enums_AllOfTheDefinitions_KeepNamesValuesAndFlags()
    {
        var names = new GeneratedTypeNames(Generator.Definitions.All);
        foreach (EnumDefinition definition in Generator.Definitions.All.Enums)
        {
            Type type = typeof(MavType).Assembly.GetType(
                "Rabit.Mavlink.Messages." + names.OfEnum(definition.Name), throwOnError: true)!;
            Assert.Equal(definition.IsBitmask, type.IsDefined(typeof(FlagsAttribute), false));
            IReadOnlyDictionary<string, string> entries = EntryNames.Of(definition);
            Assert.Equal(
                definition.Entries.Select(entry => $"{entries[entry.Name]}={entry.Value}")
                    .OrderBy(text => text, StringComparer.Ordinal),
                Enum.GetNames(type)
                    .Select(name => $"{name}={Convert.ToDecimal(Enum.Parse(type, name), CultureInfo.InvariantCulture)}")
                    .OrderBy(text => text, StringComparer.Ordinal));
        }
    }
}
