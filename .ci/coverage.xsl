<?xml version="1.0" encoding="UTF-8"?>
<!-- From JaCoCo's report: one line for each package, with the share of its lines that the tests ran. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">
  <xsl:output method="text" encoding="UTF-8"/>

  <xsl:template match="/report">
    <xsl:for-each select="package">
      <xsl:sort select="@name"/>
      <xsl:call-template name="share"/>
    </xsl:for-each>
    <xsl:call-template name="share"><xsl:with-param name="of" select="'all packages'"/></xsl:call-template>
  </xsl:template>

  <xsl:template name="share">
    <xsl:param name="of" select="translate(@name, '/', '.')"/>
    <xsl:variable name="covered" select="counter[@type = 'LINE']/@covered"/>
    <xsl:variable name="all" select="$covered + counter[@type = 'LINE']/@missed"/>
    <xsl:if test="$all &gt; 0">
      <xsl:value-of select="concat(substring(concat($of, '              '), 1, 14), ' ',
          format-number($covered div $all, '0.0 %'), ' of ', $all, ' lines&#10;')"/>
    </xsl:if>
  </xsl:template>
</xsl:stylesheet>
